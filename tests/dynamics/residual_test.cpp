// The residual of forces, from the joints' rows, by its definition; which residual a row has beside its limits; what is good enough.
#include "dynamics/world_step/fast/dxResidual.h"

#include <gtest/gtest.h>

#include <ode/ode.h>

#include <cmath>
#include <limits>
#include <vector>

#include "../frame/OdeSession.h"
#include "island_rows.h"
#include "random_world.h"

#include "dynamics/world_step/exact/dxDantzigSolver.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);
constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNone = std::numeric_limits<double>::quiet_NaN();

TEST(Residual, OfARowDependsOnItsLimits) {
    EXPECT_EQ(dxKktResidual(1, -3, 0, kInfinity), 3);  // between them w is 0
    EXPECT_EQ(dxKktResidual(0, -3, 0, kInfinity), 3);  // at the lower one it is not negative
    EXPECT_EQ(dxKktResidual(0, 3, 0, kInfinity), 0);
    EXPECT_EQ(dxKktResidual(2, 3, -2, 2), 3);  // at the upper one it is not positive
    EXPECT_EQ(dxKktResidual(2, -3, -2, 2), 0);
    EXPECT_EQ(dxKktResidual(0, 3, 0, 0), 0);  // a row that may not move
    EXPECT_EQ(dxSnapToLimit(2 - 1e-10, -2, 2), 2);
    EXPECT_EQ(dxSnapToLimit(1.9, -2, 2), 1.9);
}

TEST(Residual, OfTheWorstRowIsInfiniteWhereANumberIsNotFinite) {
    for (const double bad : {kInfinity, -kInfinity, kNone}) {
        dxWorstResidual worst;
        worst.add(1, 1);
        EXPECT_EQ(worst.get(), 1);
        worst.add(0, bad);
        EXPECT_EQ(worst.get(), kInfinity);
    }
}

// w = J (inv(M) J' x + v/h + inv(M) f) + cfm/h x - c/h, in long double.
void expectDefinition(const dxIslandStep &step, const dxWorldStepProblem &problem, std::mt19937 &random) {
    std::vector<double> x(problem.rowCount), w(problem.rowCount);
    for (double &force : x) force = std::uniform_real_distribution<double>(-1, 1)(random);
    dxBodyVectors motions(problem.bodyCount), bodies(problem.bodyCount);
    std::vector<dxInverseMass> inverseMasses(problem.bodyCount);
    dxFindBodyMotions(problem, step.stepSize, motions.data());
    dxFindInverseMasses(problem, inverseMasses.data());
    dxFindRowResidual(problem, inverseMasses.data(), motions.data(), x.data(), bodies.data(), w.data());

    using Six = std::vector<long double>;
    std::vector<Six> accelerations(problem.bodyCount, Six(6));
    const auto forElements = [&](const auto &visit) {
        for (unsigned i = 0; i < problem.jointCount; ++i)
            for (unsigned side = 0; side < 2; ++side) {
                const dxWorldStepJoint &joint = problem.joints[i];
                const dxBody *const body = joint.joint->node[side].body;
                for (unsigned row = 0; body != nullptr && row < joint.rows; ++row)
                    for (unsigned k = 0; k < 6; ++k)
                        visit(joint.firstRow + row, unsigned(body->tag), k, problem.rowsOf(joint, side)[row * 6 + k]);
            }
    };
    forElements([&](unsigned row, unsigned body, unsigned k, long double element) { accelerations[body][k] += element * x[row]; });
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        const dxBody &body = *problem.bodies[i];
        const Six force = accelerations[i];
        for (unsigned axis = 0; axis < 3; ++axis) {
            accelerations[i][axis] = (force[axis] + body.facc[axis]) * body.invMass + (long double)body.lvel[axis] / step.stepSize;
            accelerations[i][3 + axis] = (long double)body.avel[axis] / step.stepSize;
            for (unsigned k = 0; k < 3; ++k)
                accelerations[i][3 + axis] += (long double)problem.inverseInertia[i].tensor[4 * axis + k] * (force[3 + k] + body.tacc[k]);
        }
    }
    std::vector<long double> expected(problem.rowCount), sums(problem.rowCount, 1);
    for (unsigned i = 0; i < problem.rowCount; ++i)
        expected[i] = (long double)problem.pairsBX[2 * i + dxJoint::GI2_CFM] * x[i] - problem.pairsBX[2 * i + dxJoint::GI2_RHS];
    forElements([&](unsigned row, unsigned body, unsigned k, long double element) {
        expected[row] += element * accelerations[body][k];
        sums[row] += std::fabs(element * accelerations[body][k]);
    });
    for (unsigned i = 0; i < problem.rowCount; ++i) EXPECT_NEAR(w[i], double(expected[i]), 1e-14 * double(sums[i])) << i;
}

TEST(Residual, IsThatOfTheJointsRows) {
    const OdeSession session;
    std::mt19937 random(5);
    unsigned islands = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        RandomWorld world({20, 30}, seed);
        world.push();
        solveIslands(world.world(), kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
            expectDefinition(step, problem, random);
            dxDantzigSolver().solve(step, problem);
            ++islands;
        });
    }
    EXPECT_GT(islands, 20u);
}

}  // namespace
