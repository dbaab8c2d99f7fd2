// A call of the exact stepper for one island: upstream's context with the workers of the island.
#pragma once

#include "config.h"
#include "objects.h"
#include "util.h"

#include "dynamics/islands/dxIslandTeam.h"

struct dxIslandCall : dxStepperProcessingCallContext {
    using dxStepperProcessingCallContext::dxStepperProcessingCallContext;
    explicit dxIslandCall(const dxStepperProcessingCallContext &context) : dxStepperProcessingCallContext(context) {}

    mutable dxIslandTeam *team = nullptr;  // null: the calling thread alone

    // Every context that a stepper of ours is given is part of a call.
    static const dxIslandCall &of(const dxStepperProcessingCallContext *context) {
        return *static_cast<const dxIslandCall *>(context);
    }
};
