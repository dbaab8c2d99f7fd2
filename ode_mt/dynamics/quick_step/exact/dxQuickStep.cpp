#include "dynamics/quick_step/exact/dxQuickStep.h"

#include "core/dxCacheLine.h"
#include "dynamics/quick_step/dxIslandBodies.h"
#include "dynamics/quick_step/dxJointRows.h"
#include "dynamics/quick_step/sor/dxSorSolver.h"
#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxStepTimeline.h"

namespace {

// Upstream's estimate for an island (dxEstimateQuickStepMemoryRequirements), which a user's allocator sees, is for other arrays: for
// each row 128 + 96 bytes of Jacobian and impulse, and 36 of lambda, indices, orders and levels; for each body 96 + 48. Ours take
// 256 + 4 and 80 + 64 (in double precision), so they fit. The arena asserts it at every allocation.
dxIslandProblem makeProblem(const dxIslandStep &step, dxIslandBody *bodies, unsigned rows) {
    dxIslandProblem problem;
    problem.rowCount = rows;
    problem.bodyCount = step.island.bodyCount;
    problem.bodies = bodies;
    problem.rows = step.arena->AllocateOveralignedArray<dxConstraintRow>(rows, kCacheLine);
    // Behind the rows without a gap.
    problem.accelerations = step.arena->AllocateOveralignedArray<dxSpatialMotion>(problem.bodyCount, alignof(dxSpatialMotion));
    problem.order = step.arena->AllocateArray<int>(rows);
    return problem;
}

}  // namespace

void dxQuickStep(const dxIslandStep &step) {
    auto *const bodies = step.arena->AllocateArray<dxIslandBody>(step.island.bodyCount);
    dxNotificationPolicy notifications(step);
    dxGatherBodies(step, bodies);                                              // parallel
    dxJointRows joints(step);                                                  // serial
    if (joints.rowCount() == 0) {
        dxIntegrateVelocities(step, bodies, nullptr, notifications);           // parallel
    } else {
        const dxIslandProblem problem = makeProblem(step, bodies, joints.rowCount());
        joints.read(problem.rows);                                             // parallel, if there are contacts alone
        dxFindFreeAccelerations(step, problem);                                // parallel
        {
            const dxSolverSpan span(problem.rowCount);
            dxSorSolver(step).solve(problem);                                  // parallel
        }
        joints.giveFeedback(problem.rows);                                     // serial
        dxIntegrateVelocities(step, bodies, problem.accelerations, notifications);  // parallel
    }
    dxMoveBodies(step, notifications);                                         // positions parallel; spaces and the user are told serially
}
