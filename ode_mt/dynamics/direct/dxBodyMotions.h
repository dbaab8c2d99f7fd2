// What moves an island's bodies before its joints do: v/h + inv(M) f, a change of velocity per step size. In doubles, whatever dReal is.
#pragma once

#include "dynamics/direct/dxBodyBlocks.h"

struct dxExactProblem;

// By tag.
void dxFindBodyMotions(const dxExactProblem &problem, double stepSize, dxBodyVectors &motions);
