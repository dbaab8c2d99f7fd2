// One island in one step, as a stepper gets it, and the workers of a large one.
//
// Threading: steppers of different islands run at the same time.
#pragma once

#include "dynamics/step/islands/dxIsland.h"
#include "threading/dxTaskRunner.h"
#include "threading/payoff/dxSharingPolicy.h"

class dxFastQuickStepState;

// Workers that step one large island together, and their state from step to step: memory and measurements.
struct dxLargeIslandWorkers {
    dxTaskRunner *runner = nullptr;
    bool isAlwaysParallel = false;  // parallel whenever the island is large enough; otherwise the measured times decide
    dxSharingPolicy solvePolicy;    // of the exact step's triangular solves
};

struct dxIslandStep {
    dxWorld *world;
    dReal stepSize;
    dxIsland island;
    dxWorldProcessMemArena *arena;  // of the size that upstream's estimate for this stepper asks for
    dxLargeIslandWorkers *islandWorkers = nullptr;  // of a large island; null: the calling thread alone
    dxFastQuickStepState *fastQuickStep = nullptr;  // of a fast dWorldQuickStep; null otherwise

    dxTaskRunner &runner() const { return islandWorkers != nullptr ? *islandWorkers->runner : dxTaskRunner::alone(); }
};
