// What comes before a step: working memory and islands, for both steppers.
#pragma once

#include "dynamics/step/islands/dxIsland.h"
#include "dynamics/step/islands/dxIslandGroups.h"

// In place of dxReallocateWorldProcessContext (util.cpp), and with the same effect (the seam is dxPrepareStepIslands):
// the user's memory manager is asked for blocks of the same sizes in the same order, and `info` gets upstream's islands.
//
//   estimate  the stepper's own estimate of the memory that it needs for an island
//
// Returns false where there is no memory. On the thread that steps the world.
bool dxPrepareStep(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);

// The same for groups of islands, which are then stepped as if each were one island.
bool dxPrepareGroups(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes);
