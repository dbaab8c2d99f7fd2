// Solutions of the methods of the fast dWorldStep beside that of Dantzig's algorithm: residuals are no larger, and where that of Dantzig's
// algorithm is small, bodies are accelerated as by it.
#pragma once

#include <gtest/gtest.h>

#include <ode/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "island_rows.h"
#include "kept_messages.h"

#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "dynamics/world_step/fast/dxBodySpaceSolver.h"

// Residuals, as parts of the largest b: what is none, and up to which solutions are compared. Sums are rounded.
constexpr double kNegligible = 1e-12, kComparable = 1e-12, kRounding = 8 * std::numeric_limits<double>::epsilon();

// inv(M) J' x, by body.
inline std::vector<double> accelerationsOf(const dxWorldStepProblem &problem) {
    std::vector<double> forces(std::size_t(problem.bodyCount) * 6), accelerations(forces.size());
    for (unsigned i = 0; i < problem.jointCount; ++i)
        for (unsigned side = 0; side < 2; ++side) {
            const dxWorldStepJoint &joint = problem.joints[i];
            const dxBody *const body = joint.joint->node[side].body;
            if (body == nullptr) continue;
            for (unsigned row = 0; row < joint.rows; ++row)
                for (unsigned k = 0; k < 6; ++k)
                    forces[std::size_t(body->tag) * 6 + k] += double(problem.rowsOf(joint, side)[row * 6 + k]) *
                                                              problem.pairsBX[(std::size_t(joint.firstRow) + row) * 2 + 1];
        }
    for (unsigned i = 0; i < problem.bodyCount; ++i)
        for (unsigned axis = 0; axis < 3; ++axis) {
            accelerations[i * 6 + axis] = forces[i * 6 + axis] * problem.bodies[i]->invMass;
            for (unsigned k = 0; k < 3; ++k)
                accelerations[i * 6 + 3 + axis] += double(problem.inverseInertia[i].tensor[4 * axis + k]) * forces[i * 6 + 3 + k];
        }
    return accelerations;
}

inline double largestOf(const std::vector<double> &numbers) {
    double largest = 0;
    for (const double number : numbers) largest = std::max(largest, std::fabs(number));
    return largest;
}

inline double largestDifference(const std::vector<double> &a, const std::vector<double> &b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
    return largest;
}

struct Tally {
    unsigned islands = 0, unsolved = 0, compared = 0;
    unsigned better = 0;  // residual than upstream's
};

struct Solution {
    double residual;
    std::vector<double> accelerations;
};

// Calls `solve`, which writes forces, and leaves the problem as it was.
template <class Solve>
std::optional<Solution> solveAside(const dxWorldStepProblem &problem, dxBodySpaceSolver &judge, const Solve &solve) {
    const std::vector<dReal> pairs(problem.pairsBX, problem.pairsBX + 2 * std::size_t(problem.rowCount));
    std::optional<Solution> solution;
    if (solve()) solution = {judge.residualOf(problem), accelerationsOf(problem)};
    std::copy(pairs.begin(), pairs.end(), problem.pairsBX);
    return solution;
}

// `allowed`: times upstream's residual.
inline void expectAsExact(const std::optional<Solution> &ours, const Solution &upstreams, const dxInteriorPoint::Scale &scale, double allowed,
                   Tally &tally) {
    ++tally.islands;
    tally.unsolved += !ours;
    if (!ours) return;
    EXPECT_LE(ours->residual, allowed * std::max(upstreams.residual, kNegligible * scale.b + kRounding * scale.sum));
    tally.better += ours->residual < upstreams.residual;
    // Where upstream's algorithm gives up, or rows contradict one another, there is nothing to compare.
    if (upstreams.residual > kComparable * scale.b) return;
    ++tally.compared;
    EXPECT_LE(largestDifference(ours->accelerations, upstreams.accelerations), 1e-9 * largestOf(upstreams.accelerations));
}

class ComparedSolutions : public testing::Test {
protected:
    ComparedSolutions() {
        dInitODE2(0);
        keptMessages.clear();
        dSetMessageHandler(keepMessage);
        dSetDebugHandler(keepMessageAndLeave);
    }
    ~ComparedSolutions() override {
        dSetMessageHandler(nullptr);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }

    // Solves an island by the body space solver, which judges all solutions, by `solve`, which writes forces, and by Dantzig's algorithm, whose
    // forces are left. `allowed`: as expectAsExact has it.
    template <class Solve>
    void compare(const dxIslandStep &step, const dxWorldStepProblem &problem, double allowed, const Solve &solve) {
        const bool isJudged = m_judge.read(problem, step.stepSize, step.runner()) && m_judge.solve(step.runner());
        const std::optional<Solution> ours = solveAside(problem, m_judge, solve);
        dxDantzigSolver().solve(step, problem);
        if (!isJudged) return;
        const Solution upstreams{m_judge.residualOf(problem), accelerationsOf(problem)};
        expectAsExact(ours, upstreams, m_judge.scale(), allowed, m_tally);
    }

    static unsigned countBilateralRows(const dxWorldStepProblem &problem) {
        unsigned count = 0;
        for (unsigned i = 0; i < problem.rowCount; ++i) count += problem.isBilateral(i);
        return count;
    }

    dxBodySpaceSolver m_judge;
    Tally m_tally;
};
