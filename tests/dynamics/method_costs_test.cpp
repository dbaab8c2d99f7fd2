// Which method is chosen for an island: statistics of its problem, and what follows for stars, wheels, chains, nets, robots and walls.
#include "dynamics/world_step/fast/dxMethodCosts.h"

#include <gtest/gtest.h>

#include <limits>

#include "brick_wall.h"
#include "island_rows.h"
#include "joint_world.h"
#include "robot_world.h"

#include "dynamics/world_step/exact/dxDantzigSolver.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

struct Island {
    dxLcpStatistics statistics;
    double activeShare = 0;

    dxWorldStepMethod method() const { return dxMethodCosts::of(statistics, activeShare).cheapest(); }
};

// Of the world's last island, which is stepped.
Island lookAt(dWorldID world) {
    Island island;
    solveIslands(world, kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
        island = {dxLcpStatistics::of(problem, *step.arena), dxFindActiveShare(problem, step.stepSize, *step.arena)};
        dxDantzigSolver().solve(step, problem);
    });
    return island;
}

class MethodCosts : public testing::Test {
protected:
    MethodCosts() { dInitODE2(0); }
    ~MethodCosts() override { dCloseODE(); }
};

// Each ray's rows have elements in common with all before them.
TEST_F(MethodCosts, AStarIsDense) {
    JointWorld star;
    star.addStar(20);
    const dxLcpStatistics statistics = lookAt(star.world()).statistics;
    EXPECT_EQ(statistics.bodies, 21u);
    EXPECT_EQ(statistics.joints, 20u);
    EXPECT_EQ(statistics.rows, 60u);
    EXPECT_EQ(statistics.unilateralRows, 0u);
    EXPECT_EQ(statistics.eliminatedJoints, 20u);
    EXPECT_EQ(statistics.eliminatedRows, 60u);
    double elements = 0, squares = 0, products = 0;
    for (unsigned ray = 0; ray < 20; ++ray) {
        elements += 3 * 3 * (ray + 1);
        squares += 3 * 9 * (ray + 1) * (ray + 1);
        products += ray * (ray + 1) / 2;
    }
    EXPECT_EQ(statistics.skyline, elements);
    EXPECT_EQ(statistics.skylineSquares, squares);
    EXPECT_EQ(statistics.blocks, 20 * 19 / 2);
    EXPECT_EQ(statistics.products, products);
}

TEST_F(MethodCosts, AChainIsSparse) {
    JointWorld chain;
    chain.addChain(20);
    const dxLcpStatistics statistics = lookAt(chain.world()).statistics;
    EXPECT_EQ(statistics.rows, 60u);
    EXPECT_LE(statistics.skyline, 60 * 9);
    EXPECT_EQ(statistics.blocks, 19);
    EXPECT_EQ(statistics.products, 19);
}

// A hinge's motor has limits and comes after its other rows, a contact has nothing else.
TEST_F(MethodCosts, ARobotHasUnilateralRows) {
    RobotWorld robot({1, 17, 8}, 3);
    const Island island = lookAt(robot.world());
    EXPECT_EQ(island.statistics.joints, 24u);
    EXPECT_EQ(island.statistics.rows, 16 * 6 + 8 * 3);
    EXPECT_EQ(island.statistics.unilateralRows, 16 + 8 * 3);
    EXPECT_EQ(island.statistics.eliminatedJoints, 16u);
    EXPECT_EQ(island.statistics.eliminatedRows, 80u);
    EXPECT_EQ(island.method(), dxWorldStepMethod::Elimination);
}

// More unilateral rows than bodies have freedoms contradict one another: neither elimination nor an interior point is of use.
TEST_F(MethodCosts, ARobotInACrowdOfContactsIsLeftToDantzig) {
    RobotWorld robot({1, 9, 30}, 3);
    const Island island = lookAt(robot.world());
    EXPECT_EQ(island.statistics.bilateralRows(), 40u);
    EXPECT_EQ(island.statistics.unilateralRows, 8 + 30 * 3);
    EXPECT_EQ(island.method(), dxWorldStepMethod::Dantzig);
}

template <class Add>
dxWorldStepMethod methodFor(const Add &add) {
    JointWorld world;
    add(world);
    return lookAt(world.world()).method();
}

TEST_F(MethodCosts, StarsAndWheelsAreNotEliminated) {
    for (const unsigned rays : {5u, 14u, 30u}) {
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addStar(rays); }), dxWorldStepMethod::Dantzig) << rays;
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addWheel(rays); }), dxWorldStepMethod::Dantzig) << rays;
    }
    for (const unsigned rays : {120u, 250u, 400u}) {
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addStar(rays); }), dxWorldStepMethod::BodySpace) << rays;
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addWheel(rays); }), dxWorldStepMethod::BodySpace) << rays;
    }
}

TEST_F(MethodCosts, ChainsAndNetsAreEliminatedUnlessSmall) {
    for (const unsigned links : {5u, 10u})
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addChain(links); }), dxWorldStepMethod::Dantzig) << links;
    for (const unsigned links : {100u, 400u})
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addChain(links); }), dxWorldStepMethod::Elimination) << links;
    EXPECT_EQ(methodFor([&](JointWorld &world) { world.addNet(3); }), dxWorldStepMethod::Dantzig);
    for (const unsigned side : {7u, 10u})
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addNet(side); }), dxWorldStepMethod::Elimination) << side;
}

// Contacts that are pressed are work for Dantzig's algorithm, others are none.
TEST_F(MethodCosts, WallsAreSolvedInBodySpaceUnlessTheyFlyApart) {
    for (const dReal velocity : {0, 1}) {
        BrickWall::Shape statistics;
        statistics.side = 4;
        BrickWall wall(statistics);
        wall.collide();
        for (const dBodyID brick : wall.bricks()) {
            const dReal *const position = dBodyGetPosition(brick);
            dBodySetLinearVel(brick, 10 * velocity * position[0], 10 * velocity * position[1], 10 * velocity * position[2]);
        }
        const Island island = lookAt(wall.world());
        EXPECT_EQ(island.statistics.unilateralRows, island.statistics.rows);
        EXPECT_EQ(island.statistics.eliminatedJoints, 0u);
        if (velocity == 0) {
            EXPECT_GT(island.activeShare, 0.8);
            EXPECT_EQ(island.method(), dxWorldStepMethod::BodySpace);
        } else {
            EXPECT_LT(island.activeShare, 0.2);
            EXPECT_EQ(island.method(), dxWorldStepMethod::Dantzig);
        }
    }
}

// Where estimates are nearly the same, the method is that of "exact".
TEST_F(MethodCosts, OthersHaveToBeClearlyFaster) {
    EXPECT_EQ((dxMethodCosts{100, 90, 95}.cheapest()), dxWorldStepMethod::Dantzig);
    EXPECT_EQ((dxMethodCosts{100, 70, 95}.cheapest()), dxWorldStepMethod::Elimination);
    EXPECT_EQ((dxMethodCosts{100, 90, 85}.cheapest()), dxWorldStepMethod::BodySpace);
    constexpr double kImpossible = std::numeric_limits<double>::infinity();
    EXPECT_EQ((dxMethodCosts{kImpossible, kImpossible, 1e9}.cheapest()), dxWorldStepMethod::BodySpace);
    EXPECT_EQ((dxMethodCosts{1, kImpossible, 1e9}.cheapest()), dxWorldStepMethod::Dantzig);
}

}  // namespace
