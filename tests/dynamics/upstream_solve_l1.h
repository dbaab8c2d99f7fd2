// Upstream's own triangular solves, as its lcp.cpp compiles them.
#pragma once

#include <ode/common.h>

template <unsigned Stride>
void upstreamSolveStraight(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip);

template <unsigned Stride>
void upstreamSolveTransposed(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip);
