// Many worlds in one call (dODE_MT_StepWorlds): each is stepped as a whole by one worker, with the bits of a loop over
// dWorldStep or dWorldQuickStep. The stages, in this order; WORKERS marks those that are shared:
//
//   dxWorldRuns       WORKERS  cuts the call into runs of worlds in which no code of the user's runs; what is between runs is stepped
//                              as by the loop
//   prepare           WORKERS  islands of each world, and how many random numbers it draws
//   reserve           caller   the block of all worlds, cut up among them (dxDeferredRun)
//   step              WORKERS  each world on one of them, its messages and moved-notifications put off
//   commit            caller   messages and notifications in the order of the worlds
//
// A run is as good as the loop since nothing that a world of it writes is read by another: docs/threads.md.
#pragma once

#include <ode/ode.h>

#include "dynamics/step/dxCostModel.h"
#include "dynamics/step/islands/dxIsland.h"

// How worlds are stepped.
struct dxWorldStepper {
    dWorldStepFunction *step;  // the loop's
    dstepper_fn_t island;
    dmemestimate_fn_t estimate;
    dxStepperKind kind;  // of a world that is not fast
};

// "step" or "quick"; null for any other name.
const dxWorldStepper *dxFindWorldStepper(const char *name);

// Requires different worlds, none of them null. Returns whether all have been stepped: one for which there is no memory has not, and the
// others have. On the thread that steps these worlds.
bool dxStepWorlds(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize);
