// How one island is stepped, whichever strategy the step follows: on the calling thread or by several workers together.
//
// Threading: islands of one step may be stepped by several threads at the same time, each with an arena of its own.
#pragma once

#include <cstdint>

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/islands/dxIslandStep.h"

namespace dxIslandStepper {

// The one place in which a step reads the settings of its world.
dxStepCall makeCall(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper);

// `islandWorkers`: the workers that step the island together; null: the calling thread alone.
void step(const dxStepCall &call, const dxIsland &island, dxWorldProcessMemArena *arena, dxLargeIslandWorkers *islandWorkers = nullptr);

// Number of random numbers that an island of so many rows draws.
std::uint64_t drawsOf(const dxStepCall &call, unsigned rows);

// Whether any island may draw some.
bool drawsRandomNumbers(const dxStepCall &call);

// Steps all islands by upstream's own steppers, which post their stages to the implementation that the user gave the world. Returns
// false if that refuses them.
bool stepByPosting(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t estimate);

}  // namespace dxIslandStepper
