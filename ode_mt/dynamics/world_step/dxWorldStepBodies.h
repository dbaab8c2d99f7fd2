// The first and the last stage of dWorldStep, over the bodies of an island: they are gathered, and in the end the forces of rows become forces on
// bodies, forces velocities, velocities poses.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// Returns whether lanes pay for the island's bodies, and may be used.
bool dxAreBodiesForLanes(const dxIsland &island);

// Numbers the bodies (tags), adds gravity and gyroscopic torque to facc and tacc, and turns inverse inertia into the world's frame. Fills in
// the problem's bodies. `inLanes`: requires dxAreBodiesForLanes.
void dxGatherBodies(const dxIslandStep &step, dxWorldStepProblem &problem, bool inLanes = false);

// Requires x, if there are rows. Body by body, in the island's order: writes feedback of the body's joints, velocities and pose,
// tells spaces and the user that it has moved, clears facc and tacc. `areForcesApplied`: J' x is in facc and tacc already. `inLanes`: bodies
// that move quietly (dxMayDeferNotification) are moved some at a time, and spaces are told afterwards; the bits are the same.
void dxApplyResults(const dxIslandStep &step, const dxWorldStepProblem &problem, bool areForcesApplied = false, bool inLanes = false);
