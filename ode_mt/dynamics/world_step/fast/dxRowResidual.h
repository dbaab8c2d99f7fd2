// How far forces are from a solution of an island's problem, computed from its rows and not from a matrix that was made or factorised.
#pragma once

#include "dynamics/world_step/fast/dxBodyBlocks.h"

struct dxWorldStepProblem;
struct dxInverseMass;

// w = J (inv(M) J' x + u) + cfm/h x - c/h, by row. `forces` (x) by row; `inverseMasses` and `motions` (u) by tag; c/h and cfm/h are those of
// the problem. `bodies`: room for one vector for each body.
void dxFindRowResidual(const dxWorldStepProblem &problem, const dxInverseMass *inverseMasses, const dxBodyVector *motions, const double *forces,
                       dxBodyVector *bodies, double *w);
