// The last stage of the exact step: the forces of rows become forces on bodies, forces velocities, velocities poses.
#pragma once

#include "dynamics/islands/dxIslandStep.h"

struct dxExactProblem;

// Requires x, if there are rows. Body by body, in the island's order: writes feedback of the body's joints, velocities and pose,
// tells spaces and the user that it has moved, clears facc and tacc.
void dxApplyResults(const dxIslandStep &step, const dxExactProblem &problem);
