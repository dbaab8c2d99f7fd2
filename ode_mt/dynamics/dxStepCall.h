// One step of one world, as upstream's dWorldStep or dWorldQuickStep asks for it, with the islands that the search found.
#pragma once

#include "dynamics/dxCostModel.h"
#include "dynamics/islands/dxIsland.h"

struct dxStepCall {
    dxWorld *world;
    const dxWorldProcessIslandsInfo &info;
    dReal stepSize;
    dxStepperKind kind;
    unsigned count;  // of islands
};
