// Which method is chosen for an island: what is known of its problem's shape, and what follows for stars, wheels, chains, nets, robots and walls.
#include "dynamics/world_step/fast/dxMethodCosts.h"

#include <gtest/gtest.h>

#include <limits>

#include "brick_wall.h"
#include "island_rows.h"
#include "joint_world.h"
#include "robot_world.h"

#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "dynamics/world_step/fast/dxIslandShape.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

struct Island {
    dxIslandShape shape;
    double activeShare = 0;

    dxDirectMethod method() const { return dxMethodCosts::of(shape, activeShare).cheapest(); }
};

// Of the world's last island, which is stepped.
Island lookAt(dWorldID world) {
    Island island;
    solveIslands(world, kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
        island = {dxIslandShape::of(problem, *step.arena), dxFindActiveShare(problem, step.stepSize)};
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
    const dxIslandShape shape = lookAt(star.world()).shape;
    EXPECT_EQ(shape.bodies, 21u);
    EXPECT_EQ(shape.joints, 20u);
    EXPECT_EQ(shape.rows, 60u);
    EXPECT_EQ(shape.limited, 0u);
    EXPECT_EQ(shape.eliminatedJoints, 20u);
    EXPECT_EQ(shape.eliminatedRows, 60u);
    double elements = 0, squares = 0, products = 0;
    for (unsigned ray = 0; ray < 20; ++ray) {
        elements += 3 * 3 * (ray + 1);
        squares += 3 * 9 * (ray + 1) * (ray + 1);
        products += ray * (ray + 1) / 2;
    }
    EXPECT_EQ(shape.skyline, elements);
    EXPECT_EQ(shape.skylineSquares, squares);
    EXPECT_EQ(shape.blocks, 20 * 19 / 2);
    EXPECT_EQ(shape.products, products);
}

TEST_F(MethodCosts, AChainIsSparse) {
    JointWorld chain;
    chain.addChain(20);
    const dxIslandShape shape = lookAt(chain.world()).shape;
    EXPECT_EQ(shape.rows, 60u);
    EXPECT_LE(shape.skyline, 60 * 9);
    EXPECT_EQ(shape.blocks, 19);
    EXPECT_EQ(shape.products, 19);
}

// A hinge's motor has limits and comes after its other rows, a contact has nothing else.
TEST_F(MethodCosts, ARobotHasRowsWithLimits) {
    RobotWorld robot({1, 17, 8}, 3);
    const Island island = lookAt(robot.world());
    EXPECT_EQ(island.shape.joints, 24u);
    EXPECT_EQ(island.shape.rows, 16 * 6 + 8 * 3);
    EXPECT_EQ(island.shape.limited, 16 + 8 * 3);
    EXPECT_EQ(island.shape.eliminatedJoints, 16u);
    EXPECT_EQ(island.shape.eliminatedRows, 80u);
    EXPECT_EQ(island.method(), dxDirectMethod::Elimination);
}

// More rows with limits than bodies have freedoms contradict one another: neither elimination nor an interior point is of use.
TEST_F(MethodCosts, ARobotInACrowdOfContactsIsLeftToDantzig) {
    RobotWorld robot({1, 9, 30}, 3);
    const Island island = lookAt(robot.world());
    EXPECT_EQ(island.shape.unlimited(), 40u);
    EXPECT_EQ(island.shape.limited, 8 + 30 * 3);
    EXPECT_EQ(island.method(), dxDirectMethod::Dantzig);
}

template <class Add>
dxDirectMethod methodFor(const Add &add) {
    JointWorld world;
    add(world);
    return lookAt(world.world()).method();
}

TEST_F(MethodCosts, StarsAndWheelsAreNotEliminated) {
    for (const unsigned rays : {5u, 14u, 30u}) {
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addStar(rays); }), dxDirectMethod::Dantzig) << rays;
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addWheel(rays); }), dxDirectMethod::Dantzig) << rays;
    }
    for (const unsigned rays : {120u, 250u, 400u}) {
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addStar(rays); }), dxDirectMethod::BodySpace) << rays;
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addWheel(rays); }), dxDirectMethod::BodySpace) << rays;
    }
}

TEST_F(MethodCosts, ChainsAndNetsAreEliminatedUnlessSmall) {
    for (const unsigned links : {5u, 10u}) EXPECT_EQ(methodFor([&](JointWorld &world) { world.addChain(links); }), dxDirectMethod::Dantzig) << links;
    for (const unsigned links : {100u, 400u})
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addChain(links); }), dxDirectMethod::Elimination) << links;
    EXPECT_EQ(methodFor([&](JointWorld &world) { world.addNet(3); }), dxDirectMethod::Dantzig);
    for (const unsigned side : {7u, 10u})
        EXPECT_EQ(methodFor([&](JointWorld &world) { world.addNet(side); }), dxDirectMethod::Elimination) << side;
}

// Contacts that are pressed are work for Dantzig's algorithm, others are none.
TEST_F(MethodCosts, WallsAreSolvedInBodySpaceUnlessTheyFlyApart) {
    for (const dReal velocity : {0, 1}) {
        BrickWall::Shape shape;
        shape.side = 4;
        BrickWall wall(shape);
        wall.collide();
        for (const dBodyID brick : wall.bricks()) {
            const dReal *const position = dBodyGetPosition(brick);
            dBodySetLinearVel(brick, 10 * velocity * position[0], 10 * velocity * position[1], 10 * velocity * position[2]);
        }
        const Island island = lookAt(wall.world());
        EXPECT_EQ(island.shape.limited, island.shape.rows);
        EXPECT_EQ(island.shape.eliminatedJoints, 0u);
        if (velocity == 0) {
            EXPECT_GT(island.activeShare, 0.8);
            EXPECT_EQ(island.method(), dxDirectMethod::BodySpace);
        } else {
            EXPECT_LT(island.activeShare, 0.2);
            EXPECT_EQ(island.method(), dxDirectMethod::Dantzig);
        }
    }
}

// Where estimates are nearly the same, the method is that of "exact".
TEST_F(MethodCosts, OthersHaveToBeClearlyFaster) {
    EXPECT_EQ((dxMethodCosts{100, 90, 95}.cheapest()), dxDirectMethod::Dantzig);
    EXPECT_EQ((dxMethodCosts{100, 70, 95}.cheapest()), dxDirectMethod::Elimination);
    EXPECT_EQ((dxMethodCosts{100, 90, 85}.cheapest()), dxDirectMethod::BodySpace);
    constexpr double kImpossible = std::numeric_limits<double>::infinity();
    EXPECT_EQ((dxMethodCosts{kImpossible, kImpossible, 1e9}.cheapest()), dxDirectMethod::BodySpace);
    EXPECT_EQ((dxMethodCosts{1, kImpossible, 1e9}.cheapest()), dxDirectMethod::Dantzig);
}

}  // namespace
