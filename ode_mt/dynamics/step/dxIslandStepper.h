// Steps one island, for all strategies: on the calling thread or by several workers together.
//
// Threading: several threads may step islands of one step at the same time, each with an arena of its own.
#pragma once

#include <cstdint>

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/islands/dxIslandStep.h"

namespace dxIslandStepper {

// Makes the call of a step, with the settings of its world at this moment; solvers get them from here.
dxStepCall makeCall(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper);

// Steps the island. `islandWorkers`: the workers that do so together; null: the calling thread alone.
void step(const dxStepCall &call, const dxIsland &island, dxWorldProcessMemArena *arena, dxLargeIslandWorkers *islandWorkers = nullptr);

// Returns the number of random numbers that an island of this many rows draws.
std::uint64_t drawsOf(const dxStepCall &call, unsigned rows);

// Returns whether any island may draw some.
bool drawsRandomNumbers(const dxStepCall &call);

// Steps all islands by upstream's own steppers, which post their stages to the implementation that the user gave the world. Returns
// false if that refuses them.
bool stepByPosting(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t estimate);

}  // namespace dxIslandStepper
