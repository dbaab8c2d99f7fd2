#include "dynamics/step/dxStepStrategy.h"

#include <algorithm>

#include "dynamics/step/dxRemoteSolvers.h"
#include "settings/dxLentThreads.h"
#include "settings/dxSettings.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/payoff/dxSharingPolicy.h"
#include "threading/process/dxProcess.h"
#include "upstream_facts.h"

namespace {

// Joints that make an island large enough to be stepped by several workers together.
constexpr unsigned kMinJoints = 500;

// The same for the exact step: from here on, at three rows a contact, several workers are faster at its LCP; under an algorithm that
// the user has named they begin earlier. Islands at the same time use workers better, so the rest of the world has to be small.
constexpr unsigned kMinExactJoints = 134, kMinExactJointsByName = 64;
constexpr double kMinExactShare = 0.9;

// The same for the fast dWorldStep, whose phases take some ten microseconds each.
constexpr unsigned kMinFastWorldStepJoints = 250;

// Decide under auto whether several workers step large islands; one for each stepper. They belong to the process, as the cost model does, since they
// measure the machine. The work of a step is its cost by the model.
struct LargeIslandPolicies {
    dxProcessSharingPolicy policies[kStepperKinds];

    dxProcessSharingPolicy &of(dxStepperKind kind) { return policies[static_cast<int>(kind)]; }
};
dxProcessObject<LargeIslandPolicies> largeIslandPolicies;

// Decides under auto whether remote workers that are predicted to pay do so.
struct RemotePolicy : dxProcessSharingPolicy {
    // Both ends take memory for the first problems, and the worker may be asleep.
    static constexpr int kProbe = 8, kCold = 3;

    RemotePolicy() : dxProcessSharingPolicy(kProbe, kCold) {}
};
dxProcessObject<RemotePolicy> remotePolicy;

unsigned minLargeJoints(dxStepperKind kind) {
    if (dxIsQuick(kind)) return kMinJoints;
    if (kind == dxStepperKind::WorldFast) return kMinFastWorldStepJoints;
    return dxSettings::instance().algorithm() == dxAlgorithm::Auto ? kMinExactJoints : kMinExactJointsByName;
}

// Reading a clock would take longer than the steps of most small worlds: they cost one look at their only
// island.
bool mayUseWorkers(const dxStepCall &call, dODE_MT_Reason &reason) {
    reason = dODE_MT_REASON_ITERATIONS;
    if (dxIsQuick(call.kind) && dxMayBeEndless(*call.world)) return false;
    reason = call.count == 0 ? dODE_MT_REASON_NOTHING : dODE_MT_REASON_SMALL_ISLAND;
    if (call.count != 1) return call.count > 1;
    return dxIslandCursor(call.info).next().jointCount >= minLargeJoints(call.kind);
}

// Returns how many workers the settings, the world and the machine allow. Sets `reason` if that is one.
unsigned workerLimit(const dxStepCall &call, dODE_MT_Reason &reason) {
    const dxWorld *const world = call.world;
    const dxAlgorithm algorithm = dxSettings::instance().algorithm();
    reason = dODE_MT_REASON_ALGORITHM;
    if (algorithm == dxAlgorithm::Serial) return 1;
    const bool isLent = dxWorldWorkers::given(world);
    const unsigned own = call.settings.threads;
    reason = isLent ? dODE_MT_REASON_USER_THREADING : dODE_MT_REASON_THREADS;
    unsigned limit = isLent ? dxWorldWorkers::count(world) : call.settings.threadsInForce();
    const auto lower = [&limit, &reason](unsigned bound, dODE_MT_Reason why) {
        if (limit >= 2 && bound < 2) reason = why;
        limit = std::min(limit, bound);
    };
    if (own != 0) lower(own, dODE_MT_REASON_THREADS);
    const unsigned asked = world->islands_max_threads;
    if (asked != dWORLDSTEP_THREADCOUNT_UNLIMITED) lower(asked, dODE_MT_REASON_WORLD_LIMIT);
    if (algorithm == dxAlgorithm::Auto) lower(dxSettings::instance().cores(), dODE_MT_REASON_CORES);
    if (limit >= 2 && dxTrapsFloatingPoint()) lower(1, dODE_MT_REASON_FLOAT_TRAPS);
    return limit;
}

dxIslandCosts estimateCosts(const dxStepCall &call) {
    dxIslandCosts costs;
    dxIslandCursor cursor(call.info);
    for (unsigned i = 0; i < call.count; ++i) {
        const dxIsland island = cursor.next();
        if (island.bodies[0]->moved_callback != nullptr) break;  // it and what follows goes in order
        const double cost =
            dxCostModel::islandCost(call.kind, call.world->qs.num_iterations, island.bodyCount, island.jointCount);
        costs.total += cost;
        costs.joints += island.jointCount;
        costs.bodies += island.bodyCount;
        ++costs.islands;
        costs.largest = std::max(costs.largest, cost);
        costs.maxJoints = std::max(costs.maxJoints, island.jointCount);
        costs.areOfAll = i + 1 == call.count;
    }
    return costs;
}

// One island takes so long that the others would have to wait for it.
bool hasLargeIsland(const dxStepCall &call, const dxStepPlan &plan, unsigned limit) {
    if (plan.costs.maxJoints < plan.minLargeJoints || !plan.costs.areOfAll) return false;
    const double part = call.kind == dxStepperKind::WorldExact ? kMinExactShare : 1.0 / limit;
    return plan.costs.largest >= part * plan.costs.total;
}

// The exact step measures its LCPs instead (dxLcpWorkers).
bool isLargeIslandMeasured(dxStepperKind kind) {
    return kind != dxStepperKind::WorldExact && dxSettings::instance().algorithm() == dxAlgorithm::Auto;
}

bool isLargeIslandStepFaster(dxStepperKind kind, double cost) {
    return !isLargeIslandMeasured(kind) || largeIslandPolicies->of(kind).ask(cost) == dxProcessSharingPolicy::Answer::Shared;
}

void recordLargeIslandTime(const dxStepCall &call, const dxStepPlan &plan, double ns) {
    if (!isLargeIslandMeasured(call.kind)) return;
    const bool wasParallel = plan.strategy == dxStepStrategy::LargeIsland;
    largeIslandPolicies->of(call.kind).record(wasParallel, ns, plan.costs.total);
}

// Returns the number of workers for islands at the same time; 1: the caller alone.
unsigned chooseWorkers(const dxStepCall &call, const dxIslandCosts &costs, unsigned limit) {
    const unsigned most = std::min(limit, call.count);
    if (most < 2) return 1;
    if (dxSettings::instance().algorithm() != dxAlgorithm::Auto) return most;
    return dxCostModel::instance().chooseWorkers(call.kind, costs.total, costs.largest, most);
}

// Returns how many of `limit` workers may step one island together: those that prepare it are those that solve it.
unsigned islandLimit(const dxStepCall &call, unsigned limit) {
    for (const unsigned bound : {dxIslandSteppingLimit(*call.world), call.settings.solvingLimit})
        if (bound != dWORLDSTEP_THREADCOUNT_UNLIMITED) limit = std::min(limit, bound);
    return limit;
}

void planThreads(const dxStepCall &call, dxStepPlan &plan, unsigned limit) {
    plan.minLargeJoints = minLargeJoints(call.kind);
    const unsigned workers = islandLimit(call, limit);
    const bool isLarge = hasLargeIsland(call, plan, limit);
    plan.hasLargeIsland = isLarge && workers >= 2;
    if (plan.hasLargeIsland && isLargeIslandStepFaster(call.kind, plan.costs.total)) {
        plan.strategy = dxStepStrategy::LargeIsland;
        plan.reason = dODE_MT_REASON_LARGE_ISLAND;
        plan.workers = workers;
        return;
    }
    plan.workers = chooseWorkers(call, plan.costs, limit);
    if (plan.workers >= 2) {
        plan.strategy = dxStepStrategy::IslandParallel;
        plan.reason = dODE_MT_REASON_LATE_WORKERS;
    } else {
        plan.reason = isLarge && workers < 2  ? dODE_MT_REASON_WORLD_LIMIT
                      : plan.hasLargeIsland   ? dODE_MT_REASON_LARGE_ISLAND
                      : plan.costs.areOfAll ? dODE_MT_REASON_COST
                                            : dODE_MT_REASON_MOVED_CALLBACK;
    }
}

// Returns whether the step takes longer than a message to a worker and back. If not, it is not worth reading a clock.
bool isLongEnoughForMessages(const dxStepCall &call, const dxIslandCosts &costs) {
    constexpr double kMinRemoteNs = 150e3;
    return dxSettings::instance().algorithm() != dxAlgorithm::Auto || costs.total * dxCostModel::instance().scale(call.kind) >= kMinRemoteNs;
}

void planRemote(const dxStepCall &call, dxStepPlan &plan, const dxRemoteSolvers &solvers) {
    if (dxSettings::instance().algorithm() != dxAlgorithm::Auto) {
        plan.remoteShare = 1;
        plan.isRemoteForced = true;
    } else {
        const double scale = dxCostModel::instance().scale(call.kind);
        const dxRemoteWork work{plan.costs.total * scale, plan.costs.largest * scale, plan.costs.bodies, plan.costs.joints, plan.costs.islands};
        const double share = solvers.predictShare(work, plan.workers);
        if (!(share > 0)) return;
        const auto answer = remotePolicy->ask(plan.costs.total);
        if (answer == dxProcessSharingPolicy::Answer::InUse) return;
        plan.mayBeRemote = true;
        if (answer == dxProcessSharingPolicy::Answer::Alone) return;
        plan.remoteShare = share;
    }
    plan.strategy = dxStepStrategy::IslandParallel;
}

void recordRemoteTime(const dxStepPlan &plan, double ns) {
    const bool wasRemote = plan.remoteShare > 0;
    const bool isNextRemote = remotePolicy->record(wasRemote, ns, plan.costs.total);
    if (!wasRemote && isNextRemote) dxRemoteSolvers::installed()->wake();
}

}  // namespace

bool dxMayBeEndless(const dxWorld &world) {
    constexpr unsigned kMaxIterations = 100000;
    return static_cast<unsigned>(world.qs.num_iterations) > kMaxIterations;
}

dxStepPlan dxPlanStep(const dxStepCall &call) {
    dxStepPlan plan;
    const unsigned limit = mayUseWorkers(call, plan.reason) ? workerLimit(call, plan.reason) : 1;
    const dxRemoteSolvers *const remote = dxRemoteSolvers::installed();
    bool mayBeRemote = remote != nullptr && remote->maySolve(call);
    if (limit < 2 && !mayBeRemote) return plan;
    plan.costs = estimateCosts(call);
    mayBeRemote = mayBeRemote && isLongEnoughForMessages(call, plan.costs);
    if (limit < 2 && !mayBeRemote) return plan;
    plan.isMeasured = true;
    if (limit >= 2) planThreads(call, plan, limit);
    if (mayBeRemote && plan.strategy != dxStepStrategy::LargeIsland) planRemote(call, plan, *remote);
    return plan;
}

// A limit of one thread is reported in preference to any property of the islands. Several threads may have surveyed islands that one thread then had
// to step in order.
dODE_MT_Reason dxReasonOf(const dxStepCall &call, const dxStepPlan &plan, unsigned threads) {
    const bool isInOrder = plan.reason == dODE_MT_REASON_MOVED_CALLBACK || plan.reason == dODE_MT_REASON_FEEDBACK;
    if (threads >= 2 && !isInOrder) return dODE_MT_REASON_PARALLEL;
    dODE_MT_Reason limit;
    return workerLimit(call, limit) < 2 ? limit : plan.reason;
}

// Island-parallel steps measure their parallel part themselves.
void dxLearnFromStep(const dxStepCall &call, const dxStepPlan &plan, double ns) {
    if (plan.strategy == dxStepStrategy::Serial && plan.costs.areOfAll)
        dxCostModel::instance().learnSerial(call.kind, plan.costs.total, ns);
    if (plan.hasLargeIsland) recordLargeIslandTime(call, plan, ns);
    if (plan.mayBeRemote) recordRemoteTime(plan, ns);
}
