// The first stage of the exact step: an island's bodies are numbered, gravity and gyroscopic torque are added to what the user
// has pushed them with, and their inverse inertia is turned into the world's frame.
#pragma once

#include "dynamics/islands/dxIslandStep.h"

struct dxExactProblem;

// Fills in the problem's bodies. Adds to facc and tacc, writes tags.
void dxGatherBodies(const dxIslandStep &step, dxExactProblem &problem);
