// The search for islands: bodies that enabled joints connect, in upstream's order
// (BuildIslandsAndEstimateStepperMemoryRequirements in util.cpp).
#pragma once

#include "dynamics/step/islands/dxIsland.h"
#include "dynamics/step/islands/dxIslandGroups.h"

constexpr int dxFoundTag = 1;  // of bodies and joints in islands

// Disables bodies at rest, finds the islands of the others, and returns the maximum memory that the stepper needs for
// an island.
//
//   info      gets the islands, which lie in the arena
//   estimate  the stepper's own estimate, called for each island
//   groupSizes  of groups, which then stand for islands
//
// Requires the thread that steps the world. Afterwards a body or joint in an island has dxFoundTag, all others a tag of 0 or
// below.
sizeint dxFindIslands(dxWorldProcessIslandsInfo &info, dxWorldProcessMemArena *arena, dxWorld *world, dReal stepSize,
                      dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes);
