// One island in one step: what a stepper is given.
#pragma once

#include "dynamics/step/islands/dxIsland.h"
#include "dynamics/step/islands/dxLargeIslandWorkers.h"

class dxFastQuickStepState;

struct dxIslandStep {
    dxWorld *world;
    dReal stepSize;
    dxIsland island;
    dxWorldProcessMemArena *arena;  // of the size that upstream's estimate for this stepper asks for
    dxLargeIslandWorkers *islandWorkers = nullptr;  // of a large island; null: the calling thread alone

    dxFastQuickStepState *fastQuickStep = nullptr;     // of a fast dWorldQuickStep; null otherwise

    dxTaskRunner &runner() const { return islandWorkers != nullptr ? *islandWorkers->runner : dxTaskRunner::alone(); }
};
