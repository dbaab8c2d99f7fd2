#include "dynamics/direct/dxFastSolver.h"

#include <algorithm>
#include <limits>
#include <new>

#include "config.h"
#include "objects.h"
#include "step.h"

#include "core/dxLog.h"
#include "dynamics/direct/dxDirectMemory.h"
#include "dynamics/direct/dxDirectSolver.h"
#include "dynamics/exactstep/dxDantzigSolver.h"
#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/islands/dxIslandStep.h"
#include "dynamics/islands/dxWorkingMemory.h"
#include "settings/dxStepStatistics.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcessObject.h"

namespace {

dxProcessObject<dxObjectPool<dxDirectSolver>> solvers;

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX, kForce = dxJoint::GI2_CFM;

// A solution that is not good is kept for islands of more rows: Dantzig's algorithm would need minutes for them.
constexpr unsigned kMaxDenseRows = 3000;

// Requires rows, read.
bool isLargeEnough(const dxExactProblem &problem) {
    if (problem.rowCount >= kMinDirectRows) return true;
    unsigned limited = 0;
    for (std::size_t i = 0; i < problem.rowCount; ++i)
        limited += problem.pairsLoHi[i * kPair + dxJoint::GI2_LO] > -dInfinity || problem.pairsLoHi[i * kPair + dxJoint::GI2_HI] < dInfinity;
    return limited >= kMinDirectLimitedRows;
}

// By Dantzig's algorithm, in memory from the pool. Returns false where there is none.
bool solveDensely(const dxIslandStep &step, const dxExactProblem &problem) {
    const dxIsland &island = step.island;
    const dxArenaLease arena(dxEstimateStepMemoryRequirements(island.bodies, island.bodyCount, island.joints, island.jointCount));
    if (arena.get() == nullptr) return false;
    dxIslandStep dense = step;
    dense.arena = arena.get();
    dxDantzigSolver().solve(dense, problem);
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

}  // namespace

void dxFastSolver::solve(const dxIslandStep &step, const dxExactProblem &problem) {
    if (isLargeEnough(problem))
        findForces(step, problem);
    else
        dxDantzigSolver().solve(step, problem);
}

void dxFastSolver::release() {
    solvers->clear([](dxDirectSolver *solver) { delete solver; });
}
