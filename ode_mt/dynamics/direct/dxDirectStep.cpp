#include "dynamics/direct/dxDirectStep.h"

#include <algorithm>
#include <limits>
#include <new>

#include "step.h"

#include "core/dxLog.h"
#include "dynamics/direct/dxDirectMemory.h"
#include "dynamics/direct/dxDirectSolver.h"
#include "dynamics/exactstep/dxDantzigSolver.h"
#include "dynamics/exactstep/dxExactBodies.h"
#include "dynamics/exactstep/dxExactMatrix.h"
#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/exactstep/dxExactResults.h"
#include "dynamics/exactstep/dxExactRows.h"
#include "dynamics/exactstep/dxJointOrder.h"
#include "dynamics/islands/dxWorkingMemory.h"
#include "settings/dxStepStatistics.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcessObject.h"

namespace {

dxProcessObject<dxObjectPool<dxDirectSolver>> solvers;

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX, kForce = dxJoint::GI2_CFM;

// A solution that is not good is kept for islands of more rows: Dantzig's algorithm would need minutes for them.
constexpr unsigned kMaxDenseRows = 3000;

// Lists each body's joints, as dxMakeMatrix does.
void linkBodies(dxExactProblem &problem) {
    std::fill_n(problem.links.first, problem.bodyCount, dxBodyLinks::kNone);
    for (unsigned i = 0; i < problem.jointCount; ++i)
        for (unsigned side = 0; side < dxExactProblem::kSides; ++side) {
            const dxBody *const body = problem.joints[i].joint->node[side].body;
            if (body != nullptr) problem.links.add(static_cast<unsigned>(body->tag), dxBodyLinks::linkOf(i, side));
        }
}

// Requires rows, read.
bool isLargeEnough(const dxExactProblem &problem) {
    if (problem.rowCount >= kMinDirectRows) return true;
    unsigned limited = 0;
    for (std::size_t i = 0; i < problem.rowCount; ++i)
        limited += problem.pairsLoHi[i * kPair + dxJoint::GI2_LO] > -dInfinity || problem.pairsLoHi[i * kPair + dxJoint::GI2_HI] < dInfinity;
    return limited >= kMinDirectLimitedRows;
}

// By Dantzig's algorithm, in memory from the pool. Returns false where there is none.
bool solveDensely(const dxIslandStep &step, dxExactProblem problem) {
    const dxIsland &island = step.island;
    const dxArenaLease arena(dxEstimateStepMemoryRequirements(island.bodies, island.bodyCount, island.joints, island.jointCount));
    if (arena.get() == nullptr) return false;
    dxIslandStep dense = step;
    dense.arena = arena.get();
    dxTakeMatrix(*dense.arena, problem);
    dxMakeMatrix(dense, problem);
    dxDantzigSolver(step.islandWorkers).solve(problem, *dense.arena);
    return true;
}

void clearForces(const dxExactProblem &problem) {
    for (std::size_t i = 0; i < problem.rowCount; ++i) problem.pairsBX[i * kPair + kForce] = 0;
}

// Asks Dantzig's algorithm for a problem that the direct solver has found no solution of, or none that is good.
void fallBack(const dxIslandStep &step, const dxExactProblem &problem, dxDirectSolver *solver) {
    dxStepStatistics::instance().directFallbacks.fetch_add(1, std::memory_order_relaxed);
    dxLog(dxLogLevel::info, "an island of %u rows was left to Dantzig's algorithm: residual %g", problem.rowCount,
          solver != nullptr ? solver->residual() : 0);
    const bool isFound = solver != nullptr && solver->residual() < std::numeric_limits<double>::infinity();
    const bool isSolved = (!isFound || problem.rowCount <= kMaxDenseRows) && solveDensely(step, problem);
    if (isFound && (!isSolved || !(solver->residualOf(problem) <= solver->residual())))
        solver->writeForces(problem);
    else if (!isSolved)
        clearForces(problem);
}

void findForces(const dxIslandStep &step, const dxExactProblem &problem) try {
    const dxPooledObject<dxDirectSolver> solver(*solvers);
    dxStepStatistics::instance().directIslands.fetch_add(1, std::memory_order_relaxed);
    if (solver->solve(problem, step.stepSize))
        solver->writeForces(problem);
    else
        fallBack(step, problem, &*solver);
} catch (const std::bad_alloc &) {
    fallBack(step, problem, nullptr);
}

void solveDirectly(const dxIslandStep &step, dxExactProblem &problem) {
    findForces(step, problem);
    linkBodies(problem);
}

// As the exact step does.
void solveExactly(const dxIslandStep &step, dxExactProblem &problem) {
    dxTakeMatrix(*step.arena, problem);
    dxMakeMatrix(step, problem);
    dxDantzigSolver(step.islandWorkers).solve(problem, *step.arena);
}

}  // namespace

// The stages are those of dxStepExactly, all of them serial.
void dxDirectStep(const dxIslandStep &step) {
    dxExactProblem problem;

    // Reads bodies and gravity. Writes tags and inertia, adds gravity and gyroscopic torque to the bodies' accumulators.
    dxGatherBodies(step, problem);

    // Asks joints how many rows they have (getInfo1). Writes the list of joints, and how many rows there are.
    dxOrderJoints(step, problem);

    // Asks joints for their rows (getInfo2), which may add to accumulators. Writes the Jacobian, c, cfm, limits.
    if (problem.rowCount > 0) dxReadRowsAlone(step, problem);

    // Reads velocities, accumulators, inertia, rows. Writes x, and the links from bodies to joints.
    if (problem.rowCount > 0) isLargeEnough(problem) ? solveDirectly(step, problem) : solveExactly(step, problem);

    // Reads x, rows, inertia, accumulators. Writes feedback, velocities and poses, clears accumulators; tells spaces and the
    // user of each body that has moved before it goes on to the next one.
    dxApplyResults(step, problem);
}

void dxReleaseDirectSolvers() {
    solvers->clear([](dxDirectSolver *solver) { delete solver; });
}
