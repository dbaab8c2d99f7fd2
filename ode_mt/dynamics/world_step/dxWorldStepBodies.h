// The first stage of the exact step: an island's bodies are numbered, gravity and gyroscopic torque are added to what the user
// has pushed them with, and their inverse inertia is turned into the world's frame.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// Whether lanes pay for the island's bodies, and may be used.
bool dxAreBodiesForLanes(const dxIsland &island);

// Fills in the problem's bodies. Adds to facc and tacc, writes tags. `inLanes`: requires dxAreBodiesForLanes.
void dxGatherBodies(const dxIslandStep &step, dxWorldStepProblem &problem, bool inLanes = false);
