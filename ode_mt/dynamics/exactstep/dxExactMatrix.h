// What Dantzig's algorithm solves: A = J inv(M) J' + cfm/h and b = c/h - J (v/h + inv(M) f).
#pragma once

#include <ode/common.h>

#include "dynamics/islands/dxIslandStep.h"

struct dxExactProblem;

// Requires rows, read. Returns A, in the step's arena: its lower triangle, rows dPAD(rowCount) elements apart. Writes b into
// problem.pairsBX.
dReal *dxMakeMatrix(const dxIslandStep &step, const dxExactProblem &problem);
