// One step of one world. The islands that upstream's search found are stepped in order on the calling
// thread, or at the same time on workers, or in order with all workers for each large island; the bits are the same.
//
//   dxStepStrategy decides which, from costs that it has learned
//   dxSerialStep, dxIslandParallelStep, dxLargeIslandStep do it
//   dxIslandStepper steps one island for each of them
//
// docs/step.md has the picture, docs/exactness.md the reasons why the bits are the same.
//
// Threading: different worlds may be stepped by different threads at the same time.
#pragma once

#include "dynamics/step/islands/dxIsland.h"

// Seam: upstream's dWorldStep and dWorldQuickStep call this instead of dxReallocateWorldProcessContext. It is dxPrepareStep, with the memory estimate
// of the world's solver.
bool dxPrepareStepIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);

// For one of many worlds (dxStepWorlds): search for its islands, and step them, on the calling thread, which may be a worker. Random
// numbers come from the current scope. Requires a world in whose step no code of the user's runs.
bool dxPrepareWorldIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);
void dxStepOnThisThread(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper, unsigned worker);

// Seam: upstream's dWorldStep and dWorldQuickStep call this instead of dxProcessIslands. Returns false if a threading
// implementation of the user's refuses its resources; no body has moved then.
bool dxStepIslands(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t maxCallCountEstimator);
