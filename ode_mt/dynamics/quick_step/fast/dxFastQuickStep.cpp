#include "dynamics/quick_step/fast/dxFastQuickStep.h"

#include <new>

#include "core/dxPrefetch.h"
#include "dynamics/quick_step/exact/dxQuickStep.h"
#include "dynamics/quick_step/fast/dxIterativeWorld.h"
#include "dynamics/quick_step/fast/dxOtherJoints.h"
#include "dynamics/step/islands/dxStepTimeline.h"

namespace {

void numberBodies(const dxIsland &group) {
    constexpr unsigned kPrefetchDistance = 16;
    for (unsigned i = 0; i < group.bodyCount; ++i) {
        if (i + kPrefetchDistance < group.bodyCount) dxPrefetch::lineForWrite(&group.bodies[i + kPrefetchDistance]->tag);
        group.bodies[i]->tag = static_cast<int>(i);
    }
}

// Units: rows. A contact counts as three, also where it has no friction.
unsigned countRows(const dxIsland &group, const dxConstraintPlan &plan, const dxOtherJoints &joints) {
    return 3 * (group.jointCount - static_cast<unsigned>(plan.otherJoints().size())) + joints.rowCount();
}

// Returns false if there is no memory; nothing of the bodies has changed then.
bool solve(const dxIslandStep &step, dxQuietMotion &motion) try {
    numberBodies(step.island);
    const dxIterativeWorld::Lease solver(*step.iterativeWorld);
    auto *const masses = step.arena->AllocateArray<dxIslandBody>(step.island.bodyCount);
    solver->begin(step, masses);                       // parallel: the plan beside the bodies' free motion
    const dxOtherJoints joints(step, solver->plan());  // serial
    const dxSolverSpan span(countRows(step.island, solver->plan(), joints));
    solver->solve(step, masses, joints, motion);       // parallel
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

}  // namespace

void dxFastQuickStep(const dxIslandStep &step) {
    dxQuietMotion motion(step);
    if (step.iterativeWorld == nullptr || !solve(step, motion)) return dxQuickStep(step);
    dxMoveBodies(step, motion);  // positions parallel; spaces and the user are told serially
}
