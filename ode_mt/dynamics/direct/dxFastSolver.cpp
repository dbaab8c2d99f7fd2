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
#include "dynamics/direct/dxHeldMessage.h"
#include "dynamics/direct/dxIslandShape.h"
#include "dynamics/direct/dxMethodCosts.h"
#include "dynamics/direct/dxReducedLcp.h"
#include "dynamics/direct/dxUnlimitedRows.h"
#include "dynamics/exactstep/dxDantzigSolver.h"
#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/islands/dxIslandStep.h"
#include "dynamics/islands/dxWorkingMemory.h"
#include "settings/dxStepStatistics.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcessObject.h"

namespace {

dxProcessObject<dxObjectPool<dxDirectSolver>> solvers;
dxProcessObject<dxObjectPool<dxReducedLcp>> eliminations;
dxProcessObject<dxObjectPool<dxUnlimitedRows>> unlimitedSystems;

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX, kForce = dxJoint::GI2_CFM;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A solution that is not good is kept for islands of more rows: Dantzig's algorithm would need minutes for them.
constexpr unsigned kMaxDenseRows = 3000;

// Below so many rows Dantzig's algorithm is as fast as any method, and choosing would take a part of its time.
constexpr unsigned kMinChoiceRows = 48;

// How many times as many factorisations are expected where elimination has failed.
constexpr double kFactorisationsOfFailed = 3;

// Contacts without pressure are no work for Dantzig's algorithm, so they are looked at where it would be left because of rows with limits.
dxMethodCosts findCosts(const dxIslandStep &step, const dxExactProblem &problem, const dxIslandShape &shape) {
    const dxMethodCosts costs = dxMethodCosts::of(shape);
    if (shape.limited == 0 || costs.cheapest() != dxDirectMethod::BodySpace) return costs;
    return dxMethodCosts::of(shape, dxFindActiveShare(problem, step.stepSize));
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

void countIsland() { dxStepStatistics::instance().directIslands.fetch_add(1, std::memory_order_relaxed); }

// Counts an island that another algorithm is asked to solve. `residual`: of what was found; infinity: nothing was.
void countFallback(const dxExactProblem &problem, double residual) {
    dxStepStatistics::instance().directFallbacks.fetch_add(1, std::memory_order_relaxed);
    dxLog(dxLogLevel::info, "an island of %u rows was left to Dantzig's algorithm: residual %g", problem.rowCount, residual);
}

// What became of an island.
enum class Outcome { Solved, LeftToDantzig, Unsolved };

// A solution that is not good is compared with that of Dantzig's algorithm.
Outcome solveBest(const dxIslandStep &step, const dxExactProblem &problem, dxDirectSolver &solver) {
    if (!solver.solve(problem, step.stepSize, step.runner())) {
        countFallback(problem, solver.residual());
        if (solver.residual() == kInfinity) return Outcome::Unsolved;
        if (problem.rowCount <= kMaxDenseRows && solveDensely(step, problem) && solver.residualOf(problem) <= solver.residual())
            return Outcome::LeftToDantzig;
    }
    solver.writeForces(problem);
    return Outcome::Solved;
}

Outcome solveInBodySpace(const dxIslandStep &step, const dxExactProblem &problem) {
    try {
        const dxPooledObject<dxDirectSolver> solver(*solvers);
        return solveBest(step, problem, *solver);
    } catch (const std::bad_alloc &) {
        countFallback(problem, kInfinity);
        return Outcome::Unsolved;
    }
}

// Without memory for any solver, joints have no force.
Outcome solveDenselyOrNot(const dxIslandStep &step, const dxExactProblem &problem) {
    if (solveDensely(step, problem)) return Outcome::LeftToDantzig;
    for (std::size_t i = 0; i < problem.rowCount; ++i) problem.pairsBX[i * kPair + kForce] = 0;
    return Outcome::Unsolved;
}

void findForces(const dxIslandStep &step, const dxExactProblem &problem) {
    dxHeldMessage message;
    Outcome outcome = solveInBodySpace(step, problem);
    if (outcome == Outcome::Unsolved) outcome = solveDenselyOrNot(step, problem);
    if (outcome == Outcome::LeftToDantzig) message.deliver();
}

enum class Elimination { Failed, Solved, Pushed };  // the last one with forces on the bodies

Elimination eliminateReduced(const dxIslandStep &step, const dxExactProblem &problem) {
    const dxPooledObject<dxReducedLcp> elimination(*eliminations);
    return elimination->solve(step, problem) ? Elimination::Solved : Elimination::Failed;
}

// `solve`: of dxUnlimitedRows.
Elimination eliminateUnlimited(const dxIslandStep &step, const dxExactProblem &problem, decltype(&dxUnlimitedRows::solve) solve) {
    const dxPooledObject<dxUnlimitedRows> system(*unlimitedSystems);
    if (!((*system).*solve)(step, problem)) return Elimination::Failed;
    return system->push(problem) ? Elimination::Pushed : Elimination::Solved;
}

Elimination eliminate(const dxIslandStep &step, const dxExactProblem &problem, bool hasLimits) try {
    return hasLimits ? eliminateReduced(step, problem) : eliminateUnlimited(step, problem, &dxUnlimitedRows::solve);
} catch (const std::bad_alloc &) {
    return Elimination::Failed;
}

// Nothing is chosen again for an island without limits that looks as the last one did.
Elimination eliminateKnown(const dxIslandStep &step, const dxExactProblem &problem) try {
    if (problem.unboundedJoints != problem.jointCount) return Elimination::Failed;
    return eliminateUnlimited(step, problem, &dxUnlimitedRows::solveKnown);
} catch (const std::bad_alloc &) {
    return Elimination::Failed;
}

// What cannot be eliminated has another method. Rows may contradict one another then, which is many factorisations for body space.
// Returns whether forces are on the bodies.
bool solveByElimination(const dxIslandStep &step, const dxExactProblem &problem, const dxMethodCosts &costs, bool hasLimits) {
    const Elimination elimination = eliminate(step, problem, hasLimits);
    if (elimination != Elimination::Failed) return elimination == Elimination::Pushed;
    if (kFactorisationsOfFailed * costs.bodySpace < costs.dantzig) {
        findForces(step, problem);
        return false;
    }
    countFallback(problem, kInfinity);
    return dxDantzigSolver().solve(step, problem);
}

}  // namespace

bool dxFastSolver::solve(const dxIslandStep &step, const dxExactProblem &problem) {
    if (problem.rowCount < kMinChoiceRows) return dxDantzigSolver().solve(step, problem);
    const Elimination known = eliminateKnown(step, problem);
    if (known != Elimination::Failed) {
        countIsland();
        return known == Elimination::Pushed;
    }
    const dxIslandShape shape = dxIslandShape::of(problem, *step.arena);
    const dxMethodCosts costs = findCosts(step, problem, shape);
    const dxDirectMethod method = costs.cheapest();
    if (method == dxDirectMethod::Dantzig) return dxDantzigSolver().solve(step, problem);
    countIsland();
    if (method == dxDirectMethod::Elimination) return solveByElimination(step, problem, costs, shape.limited > 0);
    findForces(step, problem);
    return false;
}

void dxFastSolver::release() {
    solvers->clear([](dxDirectSolver *solver) { delete solver; });
    eliminations->clear([](dxReducedLcp *elimination) { delete elimination; });
    unlimitedSystems->clear([](dxUnlimitedRows *system) { delete system; });
}
