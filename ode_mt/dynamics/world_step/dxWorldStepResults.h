// The last stage of the exact step: the forces of rows become forces on bodies, forces velocities, velocities poses.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// Requires x, if there are rows. Body by body, in the island's order: writes feedback of the body's joints, velocities and pose,
// tells spaces and the user that it has moved, clears facc and tacc. `isPushed`: J' x is in facc and tacc already. `inLanes`: bodies
// that move quietly (dxMovesQuietly) are moved some at a time, and spaces are told afterwards; the bits are the same.
void dxApplyResults(const dxIslandStep &step, const dxWorldStepProblem &problem, bool isPushed = false, bool inLanes = false);
