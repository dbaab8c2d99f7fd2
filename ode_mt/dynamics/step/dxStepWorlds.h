// Many worlds in one call (dODE_MT_StepWorlds): each is stepped as a whole by one worker, with the bits of a loop over
// dWorldStep or dWorldQuickStep. The stages, in this order; WORKERS marks the parallel ones:
//
//   dxWorldRuns       WORKERS  divides the call into runs of worlds in which no code of the user's runs; worlds between runs are stepped
//                              as by the loop
//   prepare           WORKERS  islands of each world, and how many random numbers it draws
//   reserve           caller   the random numbers of all worlds, as one block that is divided among them (dxDeferredRun)
//   step              WORKERS  each world on one worker, with its messages and moved-notifications deferred
//   commit            caller   messages and notifications in the order of the worlds
//
// A run is as good as the loop since nothing that a world of it writes is read by another: docs/threads.md.
//
// Threading: the thread that steps the worlds.
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

// Steps the worlds. Requires different worlds, none of them null, and the thread that steps them. Returns whether all have been stepped: one for
// which there is no memory has not, the others have.
bool dxStepWorlds(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, dReal stepSize);
