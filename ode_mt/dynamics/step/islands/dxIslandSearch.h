// Prepares a step, for all steppers: searches for islands (bodies that enabled joints connect) in upstream's order
// (BuildIslandsAndEstimateStepperMemoryRequirements in util.cpp), and takes working memory.
//
// Threading: requires the thread that steps the world.
#pragma once

#include "dynamics/step/islands/dxIsland.h"

// Sizes of groups: islands that are stepped together, as if they were one. A group ends when it has this many bodies and joints; 0: each island is
// its own.
struct dxGroupSizes {
    unsigned ofContacts = 0;  // islands that only contacts hold together
    unsigned ofJoints = 0;    // islands with other joints
};

constexpr int dxFoundTag = 1;  // of bodies and joints in islands

// Replaces dxReallocateWorldProcessContext (util.cpp), with the same effect (the seam is dxPrepareStepIslands):
// the user's memory manager is asked for blocks of the same sizes in the same order, and `info` gets upstream's islands.
//
//   estimate  the stepper's own estimate of the memory that it needs for an island
//
// Returns false if there is no memory.
bool dxPrepareStep(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);

// The same for groups of islands, which are then stepped as if each were one island.
bool dxPrepareGroups(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes);
