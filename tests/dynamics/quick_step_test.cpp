// Each stage of QuickStep gives the bits of upstream's, for every instruction set of this machine, one island after the other.
//
// Covers dxBodyForces.cpp, dxIslandBodies.cpp, dxJointRows.cpp, dxSorSolver.cpp.
#include "dynamics/quick_step/dxIslandBodies.h"
#include "dynamics/quick_step/dxJointRows.h"
#include "dynamics/quick_step/exact/dxQuickStep.h"
#include "dynamics/quick_step/sor/dxSorSolver.h"
#include "dynamics/step/islands/dxIslandSearch.h"
#include "quickstep.h"
#include "instruction_sets.h"
#include "islands_of_step.h"
#include "random_world.h"
#include "upstream_quick_step.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace {

constexpr dReal kStepSize = dReal(0.01);

class QuickStepStages : public testing::TestWithParam<RandomWorld::Shape> {
protected:
    static void SetUpTestSuite() { dInitODE2(0); }
    static void TearDownTestSuite() { dCloseODE(); }
};

template <class Number>
testing::AssertionResult sameBits(const std::vector<Number> &ours, const std::vector<Number> &upstream) {
    if (ours.size() != upstream.size()) return testing::AssertionFailure() << ours.size() << " against " << upstream.size();
    for (std::size_t i = 0; i < ours.size(); ++i)
        if (std::memcmp(&ours[i], &upstream[i], sizeof(Number)) != 0)
            return testing::AssertionFailure() << "entry " << i << ": " << ours[i] << " against " << upstream[i];
    return testing::AssertionSuccess();
}

// The columns of rows, those of absent bodies left out.
std::vector<dReal> columnsOf(const std::vector<dReal> &jacobian, const std::vector<int> &bodies) {
    std::vector<dReal> columns;
    for (std::size_t row = 0; row < bodies.size() / 2; ++row)
        for (std::size_t i = 0; i < 16; ++i)
            if (bodies[2 * row + 1] != -1 || i < 8 || i > 13) columns.push_back(jacobian[16 * row + i]);
    return columns;
}

std::vector<dReal> columnsOf(const std::vector<dxSpatialMotion> &accelerations) {
    std::vector<dReal> columns;
    for (const dxSpatialMotion &of : accelerations) columns.insert(columns.end(), of.columns, of.columns + 6);
    return columns;
}

struct Rows {
    explicit Rows(const dxIslandProblem &problem) {
        for (unsigned i = 0; i < problem.rowCount; ++i) {
            const dxConstraintRow &row = problem.rows[i];
            jacobian.insert(jacobian.end(), row.jacobian, row.jacobian + 16);
            bodies.insert(bodies.end(), row.body, row.body + 2);
            boundingRow.push_back(row.boundingRow);
            lambda.push_back(row.lambda);
        }
    }
    std::vector<dReal> jacobian, lambda;
    std::vector<int> bodies, boundingRow;
};

// Steps the island stage by stage, and compares what each leaves behind.
void expectSameStages(const dxIslandStep &step, const UpstreamQuickStep &upstream) {
    const unsigned bodyCount = step.island.bodyCount;
    std::vector<dxIslandBody> bodies(bodyCount);
    dxGatherBodies(step, bodies.data());
    std::vector<dReal> forces, invInertia, upstreamInvInertia;
    for (unsigned i = 0; i < bodyCount; ++i) {
        const dxBody &body = *step.island.bodies[i];
        forces.insert(forces.end(), body.facc, body.facc + 3);
        forces.insert(forces.end(), body.tacc, body.tacc + 3);
        invInertia.insert(invInertia.end(), bodies[i].invInertia, bodies[i].invInertia + 9);
        for (unsigned entry = 0; entry < 12; ++entry)
            if (entry % 4 != 3) upstreamInvInertia.push_back(upstream.invInertia[12 * i + entry]);
    }
    ASSERT_TRUE(sameBits(forces, upstream.forces));
    ASSERT_TRUE(sameBits(invInertia, upstreamInvInertia));

    dxJointRows joints(step);
    ASSERT_EQ(joints.rowCount(), upstream.boundingRow.size());
    std::vector<dxConstraintRow> rows(joints.rowCount());
    std::vector<dxSpatialMotion> accelerations(bodyCount);
    std::vector<int> order(rows.size());
    const dxIslandProblem problem{joints.rowCount(), bodyCount, rows.data(), bodies.data(), accelerations.data(), order.data()};
    if (!rows.empty()) {
        joints.read(rows.data());
        const Rows read(problem);
        ASSERT_TRUE(sameBits(read.bodies, upstream.bodies));
        ASSERT_TRUE(sameBits(read.boundingRow, upstream.boundingRow));
        ASSERT_TRUE(sameBits(columnsOf(read.jacobian, read.bodies), columnsOf(upstream.jacobian, read.bodies)));

        dxFindFreeAccelerations(step, problem);
        ASSERT_TRUE(sameBits(columnsOf(accelerations), upstream.freeAcceleration));

        dxSorSolver(step).solve(problem);
        const Rows solved(problem);
        ASSERT_TRUE(sameBits(columnsOf(solved.jacobian, read.bodies), columnsOf(upstream.scaledJacobian, read.bodies)));
        for (unsigned i = 0; i < rows.size(); ++i) {
            ASSERT_EQ(std::memcmp(rows[i].impulseOn1, &upstream.impulse[12 * i], sizeof rows[i].impulseOn1), 0);
            if (!rows[i].hasSecondBody()) continue;
            ASSERT_EQ(std::memcmp(rows[i].impulseOn2, &upstream.impulse[12 * i + 6], sizeof rows[i].impulseOn2), 0);
        }
        ASSERT_TRUE(sameBits(solved.lambda, upstream.lambda));
        ASSERT_TRUE(sameBits(columnsOf(accelerations), upstream.acceleration));
        joints.giveFeedback(rows.data());
    }
    dxNotificationPolicy notifications(step);
    dxIntegrateVelocities(step, bodies.data(), rows.empty() ? nullptr : accelerations.data(), notifications);
    dxMoveBodies(step, notifications);
}

TEST_P(QuickStepStages, GiveUpstreamsBits) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        RandomWorld reference(GetParam(), seed);
        reference.push();
        std::vector<UpstreamQuickStep> islands;
        dRandSetSeed(seed);
        forIslands(reference.world(), kStepSize, &dxEstimateQuickStepMemoryRequirements, [&](const dxIsland &island, dxWorldProcessMemArena *) {
            islands.push_back(stepByUpstream(reference.world(), kStepSize, island));
        });
        const unsigned long drawn = dRandGetSeed();
        for (const std::int64_t set : instructionSets()) {
            onInstructionSet(set, [&] {
                RandomWorld world(GetParam(), seed);
                world.push();
                std::size_t number = 0;
                dRandSetSeed(seed);
                forIslands(world.world(), kStepSize, &dxEstimateQuickStepMemoryRequirements,
                           [&](const dxIsland &island, dxWorldProcessMemArena *arena) {
                               ASSERT_LT(number, islands.size());
                               expectSameStages({world.world(), kStepSize, island, arena}, islands[number++]);
                           });
                EXPECT_EQ(dRandGetSeed(), drawn);
                EXPECT_EQ(world.state(), reference.state()) << "seed " << seed;
            });
        }
    }
}

// The page that puts the stages together.
TEST_P(QuickStepStages, TogetherGiveUpstreamsStep) {
    for (unsigned seed = 100; seed < 130; ++seed) {
        RandomWorld reference(GetParam(), seed), world(GetParam(), seed);
        for (int i = 0; i < 3; ++i) {
            reference.push();
            world.push();
            dRandSetSeed(seed);
            forIslands(reference.world(), kStepSize, &dxEstimateQuickStepMemoryRequirements, [&](const dxIsland &island, dxWorldProcessMemArena *) {
                stepByUpstream(reference.world(), kStepSize, island);
            });
            dRandSetSeed(seed);
            forIslands(world.world(), kStepSize, &dxEstimateQuickStepMemoryRequirements, [&](const dxIsland &island, dxWorldProcessMemArena *arena) {
                dxQuickStep({world.world(), kStepSize, island, arena});
            });
            ASSERT_EQ(world.state(), reference.state()) << "seed " << seed << ", step " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Worlds, QuickStepStages,
                         testing::Values(RandomWorld::Shape{1, 0}, RandomWorld::Shape{2, 1}, RandomWorld::Shape{9, 12},
                                         RandomWorld::Shape{60, 90}, RandomWorld::Shape{250, 400}),
                         [](const auto &info) { return std::to_string(info.param.joints) + "_joints"; });

}  // namespace
