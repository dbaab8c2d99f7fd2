// What Dantzig's algorithm solves: A = J inv(M) J' + cfm/h and b = c/h - J (v/h + inv(M) f).
#pragma once

#include <ode/common.h>

#include "dynamics/step/islands/dxIslandStep.h"

struct dxConstraintJoint;
struct dxWorldStepProblem;

// Requires rows, read. Returns A, in the step's arena: its lower triangle, rows dPAD(rowCount) elements apart. Writes b into
// problem.pairsBX.
dReal *dxMakeMatrix(const dxIslandStep &step, const dxWorldStepProblem &problem);

// What the matrix is made of beside the rows. Motions: v/h + inv(M) f, six numbers a body; puts inverse masses beside the inverse tensors. Joints: by
// numbers of bodies.
void dxFindMotions(const dxWorldStepProblem &problem, dReal stepSize, dReal *motions);
void dxListConstraintJoints(const dxWorldStepProblem &problem, dxConstraintJoint *list);
