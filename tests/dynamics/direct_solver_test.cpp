// The direct solver beside upstream's algorithm, on islands of random worlds: joints of all types, motors, stops, friction, kinematic
// bodies. Its residual is no larger, and where upstream's is small, bodies are accelerated as by upstream.
#include <gtest/gtest.h>

#include <ode/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "island_rows.h"
#include "kept_messages.h"
#include "random_world.h"

#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "dynamics/world_step/fast/dxDirectSolver.h"
#include "dynamics/world_step/fast/dxReducedLcp.h"
#include "dynamics/world_step/fast/dxUnlimitedRows.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

// Residuals, as parts of the largest b: what is none, and up to which solutions are compared. Sums are rounded.
constexpr double kNegligible = 1e-12, kComparable = 1e-12, kRounding = 8 * std::numeric_limits<double>::epsilon();

// The judge's limits of friction are those of its own normals' forces, which rounding makes others than the elimination's.
constexpr double kOtherLimits = 8;

// inv(M) J' x, by body.
std::vector<double> accelerationsOf(const dxWorldStepProblem &problem) {
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

double largestOf(const std::vector<double> &numbers) {
    double largest = 0;
    for (const double number : numbers) largest = std::max(largest, std::fabs(number));
    return largest;
}

double largestDifference(const std::vector<double> &a, const std::vector<double> &b) {
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
std::optional<Solution> solveAside(const dxWorldStepProblem &problem, dxDirectSolver &judge, const Solve &solve) {
    const std::vector<dReal> pairs(problem.pairsBX, problem.pairsBX + 2 * std::size_t(problem.rowCount));
    std::optional<Solution> solution;
    if (solve()) solution = {judge.residualOf(problem), accelerationsOf(problem)};
    std::copy(pairs.begin(), pairs.end(), problem.pairsBX);
    return solution;
}

// `allowed`: times upstream's residual.
void expectAsExact(const std::optional<Solution> &ours, const Solution &upstreams, const dxInteriorPoint::Scale &scale, double allowed,
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

class DirectSolver : public testing::Test {
protected:
    DirectSolver() {
        dInitODE2(0);
        keptMessages.clear();
        dSetMessageHandler(keepMessage);
        dSetDebugHandler(keepMessageAndLeave);
    }
    ~DirectSolver() override {
        dSetMessageHandler(nullptr);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }

    // Solves each island three times, and leaves upstream's forces.
    void compareSolutions(const dxIslandStep &step, const dxWorldStepProblem &problem) {
        const std::optional<Solution> direct = solveAside(problem, m_solver, [&] {
            if (!m_solver.read(problem, step.stepSize, step.runner()) || !m_solver.solve(step.runner())) return false;
            m_solver.writeForces(problem);
            return true;
        });
        const std::optional<Solution> reduced = solveAside(problem, m_solver, [&] { return m_reduced.solve(step, problem); });
        std::optional<Solution> unlimited;
        const bool isUnlimited = countRowsWithoutLimits(problem) == problem.rowCount;
        if (isUnlimited) unlimited = solveAside(problem, m_solver, [&] { return m_unlimited.solve(step, problem); });
        dxDantzigSolver().solve(step, problem);
        if (!direct) {
            ++m_direct.unsolved;
            return;
        }
        const Solution upstreams{m_solver.residualOf(problem), accelerationsOf(problem)};
        expectAsExact(direct, upstreams, m_solver.scale(), 1, m_direct);
        if (countRowsWithoutLimits(problem) > 0) expectAsExact(reduced, upstreams, m_solver.scale(), kOtherLimits, m_eliminated);
        if (isUnlimited) expectAsExact(unlimited, upstreams, m_solver.scale(), 1, m_alone);
    }

    static unsigned countRowsWithoutLimits(const dxWorldStepProblem &problem) {
        unsigned count = 0;
        for (unsigned i = 0; i < problem.rowCount; ++i)
            count += problem.pairsLoHi[2 * i] == -dInfinity && problem.pairsLoHi[2 * i + 1] == dInfinity;
        return count;
    }

    dxDirectSolver m_solver;
    dxReducedLcp m_reduced;
    dxUnlimitedRows m_unlimited;
    Tally m_direct, m_eliminated, m_alone;
};

// Bodies in a tree with rings, held by joints whose rows have no limits.
class UnlimitedWorld {
public:
    // `kinds`: of joints, from few rows to many.
    UnlimitedWorld(unsigned bodies, unsigned kinds, unsigned seed) : m_random(seed), m_world(dWorldCreate()) {
        dWorldSetGravity(m_world, 0, 0, -10);
        for (unsigned i = 0; i < bodies; ++i) {
            m_bodies.push_back(dBodyCreate(m_world));
            dMass mass;
            dMassSetBoxTotal(&mass, dReal(1 + i % 3), dReal(0.3), dReal(0.5), dReal(0.9));
            dBodySetMass(m_bodies.back(), &mass);
            dBodySetPosition(m_bodies.back(), dReal(i), number(), number());
            dBodySetAngularVel(m_bodies.back(), number(), number(), number());
            addJoint(i, i > 0 ? static_cast<int>(i - 1 - m_random() % std::min(i, 4u)) : -1, kinds);
            if (i > 4 && i % 5 == 0) addJoint(i, static_cast<int>(m_random() % (i - 3)), 2);
        }
    }
    ~UnlimitedWorld() { dWorldDestroy(m_world); }
    UnlimitedWorld(const UnlimitedWorld &) = delete;
    UnlimitedWorld &operator=(const UnlimitedWorld &) = delete;

    dWorldID world() const { return m_world; }

private:
    dReal number() { return dReal(std::uniform_real_distribution<double>(-1, 1)(m_random)); }

    // `other`: -1 is the world.
    void addJoint(unsigned body, int other, unsigned kinds) {
        static dJointID (*const create[])(dWorldID, dJointGroupID) = {&dJointCreateDBall,  &dJointCreateBall,   &dJointCreateUniversal,
                                                                      &dJointCreateHinge, &dJointCreateSlider, &dJointCreateFixed};
        const unsigned kind = m_random() % kinds;
        const dJointID joint = create[kind](m_world, nullptr);
        dJointAttach(joint, m_bodies[body], other >= 0 ? m_bodies[static_cast<unsigned>(other)] : nullptr);
        const dReal *const here = dBodyGetPosition(m_bodies[body]);
        const dReal x = here[0] - dReal(0.4), y = here[1] + number() / 2, z = here[2] + number() / 2;
        if (kind == 0) dJointSetDBallAnchor1(joint, x, y, z);
        if (kind == 1) dJointSetBallAnchor(joint, x, y, z);
        if (kind == 2) dJointSetUniversalAnchor(joint, x, y, z);
        if (kind == 3) dJointSetHingeAnchor(joint, x, y, z);
        if (kind == 5) dJointSetFixed(joint);
    }

    std::mt19937 m_random;
    const dWorldID m_world;
    std::vector<dBodyID> m_bodies;
};

TEST_F(DirectSolver, SolvesRowsWithoutLimitsAloneAsExactlyAsUpstreams) {
    for (const unsigned kinds : {1u, 2u, 3u, 6u})
        for (const unsigned bodies : {2u, 9u, 30u})
            for (unsigned seed = 0; seed < 8; ++seed) {
                const UnlimitedWorld world(bodies, kinds, seed);
                for (int i = 0; i < 3; ++i)
                    solveIslands(world.world(), kStepSize,
                                 [&](const dxIslandStep &step, const dxWorldStepProblem &problem) { compareSolutions(step, problem); });
            }
    EXPECT_GE(m_alone.islands, 280u);
    EXPECT_LT(m_alone.unsolved, m_alone.islands / 10);
    EXPECT_GT(m_alone.compared, m_alone.islands / 2);
}

const RandomWorld::Shape kShapes[] = {{2, 1}, {2, 6}, {5, 6}, {9, 20}, {20, 30}, {12, 60}, {60, 120}};

TEST_F(DirectSolver, IsAsExactAsUpstreams) {
    for (const RandomWorld::Shape &shape : kShapes)
        for (unsigned seed = 0; seed < 20; ++seed) {
            RandomWorld world(shape, seed);
            for (int i = 0; i < 3; ++i) {
                world.push();
                solveIslands(world.world(), kStepSize,
                             [&](const dxIslandStep &step, const dxWorldStepProblem &problem) { compareSolutions(step, problem); });
            }
        }
    EXPECT_GT(m_direct.islands, 500u);
    EXPECT_EQ(m_direct.unsolved, 0u);
    EXPECT_GT(m_direct.compared, m_direct.islands / 3);
    EXPECT_GT(m_direct.better, m_direct.islands / 2);
    EXPECT_GT(m_eliminated.islands, 500u);
    EXPECT_LT(m_eliminated.unsolved, m_eliminated.islands / 2);  // joints at random contradict one another
    EXPECT_GT(m_eliminated.compared, m_eliminated.islands / 3);
}

}  // namespace
