#include "dynamics/dxStep.h"

#include "core/dxStopwatch.h"
#include "dynamics/dxIslandParallelStep.h"
#include "dynamics/dxIslandStepper.h"
#include "dynamics/dxLargeIslandStep.h"
#include "dynamics/dxSerialStep.h"
#include "dynamics/dxStepStrategy.h"
#include "dynamics/direct/dxDirectMemory.h"
#include "dynamics/islands/dxStepPreparation.h"
#include "settings/dxWorldSolver.h"
#include "settings/dxWorldWorkers.h"
#include "step.h"

namespace {

void follow(const dxStepPlan &plan, const dxStepCall &call) {
    switch (plan.strategy) {
        case dxStepStrategy::Serial: return dxSerialStep(call).run();
        case dxStepStrategy::IslandParallel: return dxIslandParallelStep(call, plan).run();
        case dxStepStrategy::LargeIsland: return dxRunLargeIslandStep(call, plan);
    }
}

void followAndLearn(const dxStepPlan &plan, const dxStepCall &call) {
    const dxStopwatch stopwatch;
    follow(plan, call);
    dxLearnFromStep(call, plan, stopwatch.ns());
}

// The direct solver makes no matrix of rows by rows. Where the user's functions step the world, upstream's stepper does.
bool isSteppedDirectly(const dxWorld *world, dmemestimate_fn_t estimate) {
    return estimate == &dxEstimateStepMemoryRequirements && dxWorldSolver::isFast(world) && !dxWorldWorkers::haveToBeAsked(world);
}

}  // namespace

bool dxPrepareStepIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate) {
    return dxPrepareStep(world, info, stepSize, isSteppedDirectly(world, estimate) ? &dxEstimateDirectStepMemory : estimate);
}

bool dxStepIslands(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t maxCallCountEstimator) {
    if (dxWorldWorkers::haveToBeAsked(world))
        return dxIslandStepper::stepByPosting(world, info, stepSize, stepper, maxCallCountEstimator);
    if (!dxWorldWorkers::prepare(world)) return false;
    const dxStepCall call{world, info, stepSize, dxIslandStepper::kindOf(world, stepper),
                          static_cast<unsigned>(info.GetIslandsCount())};
    const dxStepPlan plan = dxPlanStep(call);
    if (plan.isMeasured)
        followAndLearn(plan, call);
    else
        follow(plan, call);
    return true;
}
