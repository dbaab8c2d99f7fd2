// The third stage of the exact step: each joint writes its rows.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// Requires rows. Fills in the Jacobian, c/h and cfm/h in the places of b and x, limits, rows of normals, and the links; takes the
// memory of all that belongs to rows. Joints that push against a stop add to their bodies' facc and tacc.
void dxReadRows(const dxIslandStep &step, dxWorldStepProblem &problem);
