// One step of one world, as upstream's dWorldStep or dWorldQuickStep asks for it, with the islands that the search found.
//
// Threading: workers read it.
#pragma once

#include "dynamics/step/dxCostModel.h"
#include "dynamics/step/islands/dxIsland.h"
#include "settings/dxWorldState.h"

class dxFastQuickStepState;

struct dxStepCall {
    dxWorld *world;
    const dxWorldProcessIslandsInfo &info;
    dReal stepSize;
    dxWorldSettings settings;  // of the world when the step began
    dxStepperKind kind;
    unsigned count;  // of islands
    dxFastQuickStepState *fastQuickStep = nullptr;  // of a fast dWorldQuickStep, unless there is no memory for it
};
