#include "dynamics/step/dxStep.h"

#include <algorithm>
#include <new>

#include "core/dxStopwatch.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/step/dxIslandParallelStep.h"
#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/dxLargeIslandStep.h"
#include "dynamics/step/dxRemoteSolvers.h"
#include "dynamics/step/dxSerialStep.h"
#include "dynamics/step/dxStepStrategy.h"
#include "dynamics/step/islands/dxIslandSearch.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/world_step/fast/dxFastWorldStep.h"
#include "quickstep.h"
#include "settings/dxLentThreads.h"
#include "settings/dxWorldState.h"

namespace {

void follow(dxStepPlan &plan, const dxStepCall &call) {
    switch (plan.strategy) {
        case dxStepStrategy::Serial: return dxSerialStep(call).run();
        case dxStepStrategy::IslandParallel: return dxIslandParallelStep(call, plan).run();
        case dxStepStrategy::LargeIsland: return dxRunLargeIslandStep(call, plan);
    }
}

void followAndLearn(dxStepPlan &plan, const dxStepCall &call) {
    const dxStopwatch stopwatch;
    follow(plan, call);
    dxLearnFromStep(call, plan, stopwatch.ns());
}

// Returns whether a fast solver steps the world. If the user's threading functions have to be asked for each call (haveToBeAsked), upstream's
// steppers do.
bool isSolvedFast(const dxWorld *world) { return dxWorldSettings::of(world).isFast() && !dxWorldWorkers::haveToBeAsked(world); }

// Small islands of a fast dWorldQuickStep are solved together, in groups. In islands of contacts each is a lane of a vector: 800 bodies and joints
// fill the lanes with stacks of ten boxes, three times as many with pyramids of 55, and still fit L2. They are as few as leave 16 groups for threads;
// the number of threads itself changes no group, and so no bit. 40: beside other joints contacts are rows, and sweeps are shorter if these fit L1;
// such a group only saves preparations of tiny islands.
dxGroupSizes fastQuickStepGroups(const dxWorld &world) {
    constexpr unsigned kGroups = 16, kMin = 800, kMax = 2400, kOfJoints = 40;
    return {std::clamp(static_cast<unsigned>(world.nb + world.nj) / kGroups, kMin, kMax), kOfJoints};
}

// Returns null if there is no memory: then a step begins with zero forces, and SOR solves it.
dxFastQuickStepState *beginFastQuickStep(const dxStepCall &call) try {
    dxFastQuickStepState &own = dxFastQuickStepState::of(dxWorldState::of(call.world));
    own.begin(call.info, call.settings.solver, call.stepSize);
    return &own;
} catch (const std::bad_alloc &) {
    return nullptr;
}

dxRemoteRecord withWorkers(dxRemoteRecord record) {
    if (const dxRemoteSolvers *const remote = dxRemoteSolvers::installed()) remote->noteWorkers(record);
    return record;
}

}  // namespace

bool dxPrepareStepIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate) {
    dxStepSpan::beginSearch();
    const dxTimelineSpan search(dxStepEvents::kIslandSearch, true, dxTimelineSpan::Begin::Adjoining);
    return dxPrepareWorldIslands(world, info, stepSize, estimate);
}

bool dxPrepareWorldIslands(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate) {
    if (!isSolvedFast(world)) return dxPrepareStep(world, info, stepSize, estimate);
    if (estimate == &dxEstimateQuickStepMemoryRequirements)
        return dxPrepareGroups(world, info, stepSize, estimate, fastQuickStepGroups(*world));
    return dxPrepareStep(world, info, stepSize, &dxEstimateFastWorldStepMemory);  // no matrix of rows by rows
}

void dxStepOnThisThread(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper, unsigned worker) {
    dxStepSpan::beginSearch();  // the search has ended: the recorded step begins here
    dxStepCall call = dxIslandStepper::makeCall(world, info, stepSize, stepper);
    dxStepSpan span(world, call.count);
    if (call.kind == dxStepperKind::QuickFast) call.fastQuickStep = beginFastQuickStep(call);
    dxIslandCursor cursor(info);
    dxSerialStep(call, worker).stepIslands(cursor, call.count);
    span.setReason([](unsigned) { return dODE_MT_REASON_WORLDS; });
    span.setRemote([] { return withWorkers({}); });
}

bool dxStepIslands(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper,
                   dmaxcallcountestimate_fn_t maxCallCountEstimator) {
    dxStepSpan span(world, static_cast<unsigned>(info.GetIslandsCount()));
    if (dxWorldWorkers::haveToBeAsked(world)) {
        span.setReason([](unsigned) { return dODE_MT_REASON_USER_THREADING; });
        return dxIslandStepper::stepByPosting(world, info, stepSize, stepper, maxCallCountEstimator);
    }
    if (!dxWorldWorkers::prepare(world)) return false;
    dxStepCall call = dxIslandStepper::makeCall(world, info, stepSize, stepper);
    if (call.kind == dxStepperKind::QuickFast) call.fastQuickStep = beginFastQuickStep(call);
    dxStepPlan plan = dxPlanStep(call);
    if (plan.isMeasured)
        followAndLearn(plan, call);
    else
        follow(plan, call);
    span.setReason([&](unsigned threads) { return dxReasonOf(call, plan, threads); });
    span.setRemote([&plan] { return withWorkers(plan.remote); });
    return true;
}
