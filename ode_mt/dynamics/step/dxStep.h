// One step of one world: the islands that upstream's search found are stepped in order on the calling
// thread, or shared out to workers, or one large island to all workers; with the same bits.
//
//   dxStepStrategy decides which, from costs that it has learned
//   dxSerialStep, dxIslandParallelStep, dxLargeIslandStep do it
//   dxIslandStepper steps one island for each of them
//
// See docs/step.md for the picture and docs/exactness.md for why the bits stay the same.
#pragma once

#include "dynamics/step/islands/dxIsland.h"

// Seam: upstream's dWorldStep and dWorldQuickStep call this instead of dxReallocateWorldProcessContext. dxPrepareStep with the estimate of
// the stepper that the world's solver comes to.
bool dxPrepareStepIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);

// One of many worlds (dxStepWorlds): the islands are searched for, and then stepped, on the calling thread, which may be a worker. Random
// numbers come from the scope in force. Requires a world in whose step no code of the user's runs.
bool dxPrepareWorldIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);
void dxStepOnThisThread(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper, unsigned worker);

// Seam: upstream's dWorldStep and dWorldQuickStep call this instead of dxProcessIslands. Returns false if a threading
// implementation of the user's refuses its resources; no body has moved then.
bool dxStepIslands(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t maxCallCountEstimator);
