// A call of upstream's stepper for one island, with what ours adds to it. Upstream hands the context from
// stage to stage; the seams of its stages (ode/seams/quickstep.h) find the workers here.
#pragma once

#include "config.h"
#include "objects.h"
#include "util.h"

#include "dynamics/dxIslandTeam.h"
#include "dynamics/dxRowMemory.h"

struct dxIslandCall : dxStepperProcessingCallContext {
    using dxStepperProcessingCallContext::dxStepperProcessingCallContext;
    explicit dxIslandCall(const dxStepperProcessingCallContext &context) : dxStepperProcessingCallContext(context) {}

    mutable dxIslandTeam *team = nullptr;  // null: the calling thread alone
    mutable dxRowMemory rows;              // packed ones, while QuickStep sweeps over them

    // The island's workers, or the caller.
    dxTaskRunner &runner() const { return team != nullptr ? *team->runner : dxTaskRunner::alone(); }

    // Every context that a stepper of ours is given is part of a call.
    static const dxIslandCall &of(const dxStepperProcessingCallContext *context) {
        return *static_cast<const dxIslandCall *>(context);
    }
};
