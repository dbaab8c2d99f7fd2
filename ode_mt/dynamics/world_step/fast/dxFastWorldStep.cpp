#include "dynamics/world_step/fast/dxFastWorldStep.h"

#include <algorithm>
#include <limits>
#include <new>

#include "lcp.h"
#include "step.h"
#include "util.h"

#include "core/dxLog.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "dynamics/world_step/fast/dxDantzigTrial.h"
#include "dynamics/world_step/fast/dxBodySpaceSolver.h"
#include "dynamics/world_step/fast/dxMethodCosts.h"
#include "dynamics/world_step/fast/dxEliminatedLcp.h"
#include "dynamics/world_step/fast/dxBilateralSolver.h"
#include "dynamics/world_step/kernels/dxConstraintMatrix.h"
#include "settings/dxProcessStatistics.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcess.h"

namespace {

dxProcessObject<dxObjectPool<dxBodySpaceSolver>> solvers;
dxProcessObject<dxObjectPool<dxEliminatedLcp>> eliminations;
dxProcessObject<dxObjectPool<dxBilateralSolver>> bilateralSolvers;

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX, kForce = dxJoint::GI2_CFM;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A solution that is not good is kept for islands of more rows: Dantzig's algorithm would need minutes for them.
constexpr unsigned kMaxDenseRows = 3000;

// The energy of the residual, as part of that of regularised rows, below which other forces are taken: rows that are nearly the same have large
// forces, for which regularised rows are too soft.
constexpr double kFarLess = 0.01;

// With fewer rows Dantzig's algorithm is as fast as any method, and choosing would take a part of its time.
constexpr unsigned kMinChoiceRows = 48;

// How many times as many factorisations are expected where elimination has failed.
constexpr double kFactorisationsOfFailed = 3;

// Contacts without pressure are no work for Dantzig's algorithm, so they are looked at where it would be left because of unilateral rows.
dxMethodCosts findCosts(const dxIslandStep &step, const dxWorldStepProblem &problem, const dxLcpStatistics &statistics) {
    const dxMethodCosts costs = dxMethodCosts::of(statistics);
    if (statistics.unilateralRows == 0 || costs.cheapest() != dxWorldStepMethod::BodySpace) return costs;
    return dxMethodCosts::of(statistics, dxFindActiveShare(problem, step.stepSize, *step.arena));
}

void countIsland() { dxProcessStatistics::instance().directIslands.fetch_add(1, std::memory_order_relaxed); }

void countFallback() { dxProcessStatistics::instance().directFallbacks.fetch_add(1, std::memory_order_relaxed); }

// Counts an island that Dantzig's algorithm is asked to solve. `residual`: of what was found; infinity: nothing was.
void leaveToDantzig(const dxWorldStepProblem &problem, double residual) {
    countFallback();
    dxLog(dxLogLevel::Info, "an island of %u rows was left to Dantzig's algorithm: residual %g", problem.rowCount, residual);
}

// What became of an island. Where nothing of ours has forces for it, Dantzig's algorithm has the last word, and its message is told.
enum class Outcome { Solved, Regularised, LeftToDantzig };

// Writes forces of which least is left, unless those that are there leave far less. Returns false where there are none, or no memory.
bool regularise(const dxIslandStep &step, const dxWorldStepProblem &problem, dxBodySpaceSolver &solver) try {
    if (!solver.regularise(step.runner())) return false;
    dxLog(dxLogLevel::Info, "an island of %u rows was regularised: residual %g", problem.rowCount, solver.residual());
    const bool isTooSoft = !solver.isAnswer(solver.residual()) && solver.energyOf(problem) < kFarLess * solver.energy();
    if (!isTooSoft) solver.writeForces(problem);
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

// `unsolved`: the problem before it had forces.
bool regularise(const dxIslandStep &step, const dxWorldStepProblem &unsolved, const dxWorldStepProblem &problem) try {
    const dxPooledObject<dxBodySpaceSolver> solver(*solvers);
    return solver->read(unsolved, step.stepSize, step.runner()) && regularise(step, problem, *solver);
} catch (const std::bad_alloc &) {
    return false;
}

Outcome solveByDantzig(const dxIslandStep &step, const dxWorldStepProblem &problem, const dxHeldMessage &message) {
    const dxDantzigTrial trial(step, problem, message);
    if (trial.isAnswer()) return Outcome::Solved;
    return regularise(step, trial.unsolved(), problem) ? Outcome::Regularised : Outcome::LeftToDantzig;
}

Outcome solveByDantzig(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    dxHeldMessage message;
    const Outcome outcome = solveByDantzig(step, problem, message);
    if (outcome == Outcome::LeftToDantzig) message.deliver();
    return outcome;
}

// An island that no other method was asked to solve.
void solveByDantzigAlone(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    if (solveByDantzig(step, problem) != Outcome::Regularised) return;
    countIsland();
    countFallback();
}

// Calls solve(step) with memory from the pool. Returns false where there is none.
template <class Solve>
bool inDenseMemory(const dxIslandStep &step, const dxWorldStepProblem &problem, const Solve &solve) {
    const dxIsland &island = step.island;
    const dxArenaLease arena(dxEstimateStepMemoryRequirements(island.bodies, island.bodyCount, island.joints, island.jointCount) +
                             dxDantzigTrial::memory(problem.bodyCount, problem.rowCount));
    if (arena.get() == nullptr) return false;
    dxIslandStep dense = step;
    dense.arena = arena.get();
    solve(dense);
    return true;
}

// Of two solutions that are not good the better one is taken, and of those that are no answer none.
void improve(const dxIslandStep &step, const dxWorldStepProblem &problem, dxBodySpaceSolver &solver) {
    const double own = solver.residual();
    double dantzigs = kInfinity;
    const auto solveDensely = [&](const dxIslandStep &dense) {
        dxDantzigSolver().solve(dense, problem);
        dantzigs = solver.residualOf(problem);
    };
    if (problem.rowCount <= kMaxDenseRows) inDenseMemory(step, problem, solveDensely);
    if (dantzigs > own) solver.writeForces(problem);
    if (!solver.isAnswer(std::min(own, dantzigs))) regularise(step, problem, solver);
}

// Returns false where there is no solution.
bool solveInBodySpace(const dxIslandStep &step, const dxWorldStepProblem &problem) try {
    const dxPooledObject<dxBodySpaceSolver> solver(*solvers);
    if (solver->read(problem, step.stepSize, step.runner()) && solver->solve(step.runner())) {
        solver->writeForces(problem);
        return true;
    }
    leaveToDantzig(problem, solver->residual());
    if (solver->residual() == kInfinity) return false;
    improve(step, problem, *solver);
    return true;
} catch (const std::bad_alloc &) {
    leaveToDantzig(problem, kInfinity);
    return false;
}

// Without memory for any solver, joints have no force.
void findForces(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    dxHeldMessage message;
    if (solveInBodySpace(step, problem)) return;
    Outcome outcome = Outcome::Solved;
    if (!inDenseMemory(step, problem, [&](const dxIslandStep &dense) { outcome = solveByDantzig(dense, problem, message); }))
        for (std::size_t i = 0; i < problem.rowCount; ++i) problem.pairsBX[i * kPair + kForce] = 0;
    if (outcome == Outcome::LeftToDantzig) message.deliver();
}

enum class Elimination { Failed, Solved, Applied };  // the last one with forces on the bodies

Elimination eliminateLcp(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    const dxPooledObject<dxEliminatedLcp> elimination(*eliminations);
    return elimination->solve(step, problem) ? Elimination::Solved : Elimination::Failed;
}

// `solve`: of dxBilateralSolver.
Elimination eliminateBilateral(const dxIslandStep &step, const dxWorldStepProblem &problem, decltype(&dxBilateralSolver::solve) solve) {
    const dxPooledObject<dxBilateralSolver> system(*bilateralSolvers);
    if (!((*system).*solve)(step, problem)) return Elimination::Failed;
    return system->applyForces(problem) ? Elimination::Applied : Elimination::Solved;
}

Elimination eliminate(const dxIslandStep &step, const dxWorldStepProblem &problem, bool hasUnilateralRows) try {
    return hasUnilateralRows ? eliminateLcp(step, problem) : eliminateBilateral(step, problem, &dxBilateralSolver::solve);
} catch (const std::bad_alloc &) {
    return Elimination::Failed;
}

// Nothing is chosen again for an island of bilateral rows that has the structure of the last one.
Elimination eliminateKnown(const dxIslandStep &step, const dxWorldStepProblem &problem) try {
    if (problem.bilateralJoints != problem.jointCount) return Elimination::Failed;
    return eliminateBilateral(step, problem, &dxBilateralSolver::solveKnown);
} catch (const std::bad_alloc &) {
    return Elimination::Failed;
}

// What cannot be eliminated has another method. Rows may contradict one another then, which is many factorisations for body space.
// Returns whether forces are on the bodies.
bool solveByElimination(const dxIslandStep &step, const dxWorldStepProblem &problem, const dxMethodCosts &costs, bool hasUnilateralRows) {
    const Elimination elimination = eliminate(step, problem, hasUnilateralRows);
    if (elimination != Elimination::Failed) return elimination == Elimination::Applied;
    if (kFactorisationsOfFailed * costs.bodySpace < costs.dantzig) {
        findForces(step, problem);
        return false;
    }
    leaveToDantzig(problem, kInfinity);
    solveByDantzig(step, problem);
    return false;
}

// --- memory ------------------------------------------------------------------------------------------------

template <class Element>
sizeint sizeOf(sizeint count) {
    return dOVERALIGNED_SIZE(count * sizeof(Element), kCacheLine);
}

// Bodies, joints and rows.
sizeint sizeOfRows(sizeint bodies, sizeint joints, sizeint rows) {
    return sizeOf<dxInverseInertia>(bodies) + sizeOf<dxWorldStepJoint>(2 * joints) + sizeOf<int>(rows) +
           sizeOf<dReal>(rows * dxWorldStepProblem::kSides * dxWorldStepProblem::kElements) + 2 * sizeOf<dReal>(2 * rows) +
           sizeOf<unsigned>(bodies) + sizeOf<unsigned>(joints * dxWorldStepProblem::kSides);
}

// Of the matrix alone: small islands need not know more.
constexpr sizeint kMinMatrix = sizeint(kDantzigThreshold) * kDantzigThreshold * sizeof(dReal);

// The matrix, and what makes and solves it.
sizeint sizeOfMatrix(sizeint bodies, sizeint joints, unsigned rows) {
    const sizeint making = sizeOf<dxConstraintJoint>(joints) + sizeOf<dReal>(bodies * dxWorldStepProblem::kElements) +
                           sizeOf<dReal>(dxConstraintMatrixTask::transposedSize(rows));
    return sizeOf<dReal>(sizeint(rows) * dPAD(rows)) + std::max(making, dxEstimateSolveLCPMemoryReq(rows, false));
}

}  // namespace

bool dxFastWorldStep::solve(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    if (problem.rowCount < kMinChoiceRows) {
        solveByDantzigAlone(step, problem);
        return false;
    }
    const Elimination known = eliminateKnown(step, problem);
    if (known != Elimination::Failed) {
        countIsland();
        return known == Elimination::Applied;
    }
    const dxLcpStatistics statistics = dxLcpStatistics::of(problem, *step.arena);
    const dxMethodCosts costs = findCosts(step, problem, statistics);
    const dxWorldStepMethod method = costs.cheapest();
    if (method == dxWorldStepMethod::Dantzig) {
        solveByDantzigAlone(step, problem);
        return false;
    }
    countIsland();
    if (method == dxWorldStepMethod::Elimination) return solveByElimination(step, problem, costs, statistics.unilateralRows > 0);
    findForces(step, problem);
    return false;
}

sizeint dxEstimateFastWorldStepMemory(dxBody *const *bodies, unsigned bodyCount, dxJoint *const *joints, unsigned jointCount) {
    const sizeint upstreams = dxEstimateStepMemoryRequirements(bodies, bodyCount, joints, jointCount);
    const sizeint trial = dxDantzigTrial::memory(bodyCount, std::min(kMaxJointRows * jointCount, kDantzigThreshold));
    if (upstreams <= kMinMatrix) return upstreams + trial;
    const sizeint matrix = sizeOfMatrix(bodyCount, jointCount, kDantzigThreshold);
    if (upstreams <= matrix) return upstreams + trial;
    sizeint rows = 0;
    for (unsigned i = 0; i < jointCount; ++i) {
        dxJoint::SureMaxInfo info;
        joints[i]->getSureMaxInfo(&info);
        rows += info.max_m;
    }
    return std::min(upstreams, sizeOfRows(bodyCount, jointCount, rows) + matrix) + trial;
}
