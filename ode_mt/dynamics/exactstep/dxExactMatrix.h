// The fourth stage of the exact step: A = J inv(M) J' + cfm/h and b = c/h - J (v/h + inv(M) f).
#pragma once

#include "dynamics/islands/dxIslandStep.h"

struct dxExactProblem;

// Requires rows, read. Fills in the lower triangle of A, b, and the links.
void dxMakeMatrix(const dxIslandStep &step, dxExactProblem &problem);
