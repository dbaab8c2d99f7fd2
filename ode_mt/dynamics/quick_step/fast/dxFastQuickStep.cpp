#include "dynamics/quick_step/fast/dxFastQuickStep.h"

#include <new>

#include "core/dxPrefetch.h"
#include "dynamics/quick_step/exact/dxQuickStep.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/step/islands/dxStepTimeline.h"

namespace {

void numberBodies(const dxIsland &group) {
    constexpr unsigned kPrefetchDistance = 16;
    for (unsigned i = 0; i < group.bodyCount; ++i) {
        if (i + kPrefetchDistance < group.bodyCount) dxPrefetch::lineForWrite(&group.bodies[i + kPrefetchDistance]->tag);
        group.bodies[i]->tag = static_cast<int>(i);
    }
}

// Returns the number of rows beside those of joints in lanes. A contact counts as three, also where it has no friction.
unsigned countRows(const dxConstraintPlan &plan, const dxRowJoints &joints) { return 3 * plan.laneContacts() + joints.rowCount(); }

// Returns false if there is no memory; nothing of the bodies has changed then.
bool solve(const dxIslandStep &step, dxNotificationPolicy &notifications) try {
    numberBodies(step.island);                              // serial: writes tags
    const dxFastQuickStepState::Lease solver(*step.fastQuickStep);
    auto *const masses = step.arena->AllocateArray<dxIslandBody>(step.island.bodyCount);
    solver->begin(step, masses);                            // parallel: reads bodies and joints; writes the plan, masses, free velocities
    const dxRowJoints joints(step, solver->plan());         // serial: asks joints for rows, which may add to the bodies' accumulators
    const unsigned laneRows = solver->readJoints(step);     // serial: the same of joints in lanes
    const dxSolverSpan span(laneRows + countRows(solver->plan(), joints));
    solver->solve(step, joints, notifications);             // parallel: the stages are in dxPgsSolver.cpp; writes velocities, feedback
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

}  // namespace

void dxFastQuickStep(const dxIslandStep &step) {
    dxNotificationPolicy notifications(step);
    if (step.fastQuickStep == nullptr || !solve(step, notifications)) return dxQuickStep(step);
    dxMoveBodies(step, notifications);                      // positions parallel; spaces and the user are told serially
}
