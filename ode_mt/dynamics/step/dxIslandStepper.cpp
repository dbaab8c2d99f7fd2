#include "dynamics/step/dxIslandStepper.h"

#include <algorithm>

#include "settings/dxJointAttachment.h"
#include "dynamics/quick_step/exact/dxQuickStep.h"
#include "dynamics/quick_step/fast/dxFastQuickStep.h"
#include "dynamics/quick_step/sor/dxSorOrder.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/step/random/dxSingleStepper.h"
#include "dynamics/world_step/dxWorldStep.h"
#include "dynamics/world_step/dxWorldStepBodies.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "dynamics/world_step/fast/dxFastWorldStep.h"
#include "quickstep.h"
#include "step.h"
#include "upstream_facts.h"

namespace {

bool hasRecentJoints(const dxIsland &island) {
    return std::any_of(island.joints, island.joints + island.jointCount,
                       [](const dxJoint *joint) { return dxJointAttachment::isRecent(*joint); });
}

bool hasJoinedBodies(const dxIsland &island) {
    return std::any_of(island.bodies, island.bodies + island.bodyCount,
                       [](const dxBody *body) { return dxJointAttachment::hasRecent(*body); });
}

// Returns whether the stepper would find joints that have been attached since the island was found: upstream's stepper steps such islands.
// The exact step goes through all joints of its bodies, too.
bool isChanged(const dxWorld &world, const dxIsland &island, dxStepperKind kind) {
    if (!dxJointAttachment::hasAny(world)) return false;
    return hasRecentJoints(island) || (!dxIsQuick(kind) && hasJoinedBodies(island));
}

dxStepperKind kindOf(const dxWorldSettings &settings, dstepper_fn_t stepper) {
    const bool isFast = settings.isFast();
    if (stepper == &dxQuickStepIsland) return isFast ? dxStepperKind::QuickFast : dxStepperKind::QuickExact;
    return isFast ? dxStepperKind::WorldFast : dxStepperKind::WorldExact;
}

// On the calling thread alone.
void stepAsUpstream(const dxIslandStep &step, dxStepperKind kind) {
    const dxIsland &island = step.island;
    dxStepperProcessingCallContext context = dxSerialStepperCall(step.world, step.stepSize, step.arena, island.bodies, island.joints);
    context.AssignIslandSelection(island.bodies, island.joints, island.bodyCount, island.jointCount);
    dxIsQuick(kind) ? dxQuickStepIsland(&context) : dxStepIsland(&context);
}

// Uses memory from the pool, as the fast step's arena has no room for upstream's matrix. Without memory the island is not stepped.
void stepAsUpstreamInOwnMemory(dxIslandStep step) {
    const dxIsland &island = step.island;
    const dxArenaLease arena(dxEstimateStepMemoryRequirements(island.bodies, island.bodyCount, island.joints, island.jointCount));
    if (arena.get() == nullptr) {
        dMessage(d_ERR_UASSERT, "ODE_MT: no memory to step an island whose joints have changed during the step");
        return;
    }
    step.arena = arena.get();
    stepAsUpstream(step, dxStepperKind::WorldExact);
}

// Upstream's steppers for threading functions of the user's: the thread that gets the call of an island steps it. A world that is
// limited to one thread for islands may allow more for one island, but their order of additions would not be repeatable.
void worldStepAlone(const dxStepperProcessingCallContext *call) {
    const dxStepperProcessingCallContext alone = dxOnThisThread(*call);
    dxStepIsland(&alone);
}

void quickStepAlone(const dxStepperProcessingCallContext *call) {
    const dxStepperProcessingCallContext alone = dxOnThisThread(*call);
    dxQuickStepIsland(&alone);
}

}  // namespace

dxStepCall dxIslandStepper::makeCall(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper) {
    const dxWorldSettings settings = dxWorldSettings::of(world);
    return {world, info, stepSize, settings, kindOf(settings, stepper), static_cast<unsigned>(info.GetIslandsCount())};
}

void dxIslandStepper::step(const dxStepCall &call, const dxIsland &island, dxWorldProcessMemArena *arena,
                           dxLargeIslandWorkers *islandWorkers) {
    const dxIslandSpan span(island);
    arena->ResetState();
    const dxIslandStep step{call.world, call.stepSize, island, arena, islandWorkers, call.fastQuickStep};
    if (isChanged(*call.world, island, call.kind)) {
        call.kind == dxStepperKind::WorldFast ? stepAsUpstreamInOwnMemory(step) : stepAsUpstream(step, call.kind);
    } else if (call.kind == dxStepperKind::QuickExact) {
        dxQuickStep(step);
    } else if (call.kind == dxStepperKind::QuickFast) {
        dxFastQuickStep(step);
    } else {
        dxFastWorldStep fast;
        dxDantzigSolver dantzig;
        const bool isDirect = call.kind == dxStepperKind::WorldFast;
        dxWorldStep(step, isDirect ? static_cast<dxWorldStepSolver &>(fast) : dantzig, isDirect && dxAreBodiesForLanes(island));
    }
}

// Upstream shuffles the rows before every eighth iteration except the first, with m - 1 draws each time.
std::uint64_t dxIslandStepper::drawsOf(const dxStepCall &call, unsigned rows) {
    if (call.kind != dxStepperKind::QuickExact || rows == 0 || call.world->qs.num_iterations < 1) return 0;
    const std::uint64_t shuffles =
        (static_cast<unsigned>(call.world->qs.num_iterations) - 1) / kShuffleInterval;
    return (rows - 1) * shuffles;
}

bool dxIslandStepper::drawsRandomNumbers(const dxStepCall &call) { return drawsOf(call, 2) != 0; }

bool dxIslandStepper::stepByPosting(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize,
                                    dstepper_fn_t stepper, dmaxcallcountestimate_fn_t estimate) {
    const dxSingleStepper inTurn;
    dxTimelineSpan span(dxStepEvents::kIslandsInOrder);
    span.set(0, static_cast<std::uint64_t>(info.GetIslandsCount()));
    const dstepper_fn_t alone = stepper == &dxQuickStepIsland ? &quickStepAlone : &worldStepAlone;
    return dxProcessIslands(world, info, stepSize, alone, estimate);
}
