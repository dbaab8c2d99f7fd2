// What moves an island's bodies before its joints do: v/h + inv(M) f, a change of velocity per step size. In doubles, whatever dReal is.
#pragma once

#include "dynamics/direct/dxBodyBlocks.h"

struct dxExactProblem;

// By tag.
void dxFindBodyMotions(const dxExactProblem &problem, double stepSize, dxBodyVectors &motions);

// The largest sum of |J| |u| in a row: b is the rest of c/h and J u, and has their rounding. Where bodies fall together, that is more than a
// part of b.
double dxLargestMotion(const dxExactProblem &problem, const dxBodyVectors &motions);
