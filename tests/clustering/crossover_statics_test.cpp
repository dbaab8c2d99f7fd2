// What each pass does with static geoms, on worlds of a few boxes (thesis 5.1, 6.1, 7.1).
//
// Two robots at x = -10 and 10 give five cells of 6.3 an axis from -15.75 on: cell 0 ends at -9.45, cell 4
// begins at 9.45, and the middle one of each axis is cell 2.
#include <gtest/gtest.h>

#include "ClusteredSpace.h"
#include "CrossoverPasses.h"

namespace {

class TwoRobots : public ClusteredSpace {
public:
    explicit TwoRobots(const char *pass) : ClusteredSpace(pass) {}
    dGeomID left = robot(-10, 0, 0), right = robot(10, 0, 0);
};

TEST(CrossoverStatics, OriginalTestsTheWallApart) {
    TwoRobots world("original");
    const dGeomID wall = world.wall(0, dReal(0.6), 0, 24);
    EXPECT_EQ(world.collide(), 2u);
    EXPECT_EQ(world.clusters().count(), 2);
    EXPECT_FALSE(world.together(world.left, world.right));
    EXPECT_FALSE(world.isClustered(wall));
    EXPECT_FALSE(world.duplicates(world.left, wall));
    EXPECT_FALSE(world.oneTask(world.left, world.right));
}

TEST(CrossoverStatics, StaticPseudoMergesBothWithTheWallIntoOneTask) {
    for (const char *pass : {"static", "static-unmerged"}) {
        TwoRobots world(pass);
        const dGeomID wall = world.wall(0, dReal(0.6), 0, 24);
        EXPECT_EQ(world.collide(), 2u);
        EXPECT_FALSE(world.together(world.left, world.right)) << "membership unchanged";
        EXPECT_TRUE(world.isClustered(wall));
        EXPECT_FALSE(world.together(world.left, wall));
        EXPECT_TRUE(world.pseudoMerges(world.left, wall));
        EXPECT_TRUE(world.pseudoMerges(world.right, wall));
        EXPECT_TRUE(world.oneTask(world.left, world.right));
    }
}

TEST(CrossoverStatics, DuplicationListsTheWallInBoth) {
    for (const char *pass : {"duplication", "decluster"}) {
        TwoRobots world(pass);
        const dGeomID wall = world.wall(0, dReal(0.6), 0, 24);
        EXPECT_EQ(world.collide(), 2u);
        EXPECT_EQ(world.clusters().count(), 2);
        EXPECT_TRUE(world.duplicates(world.left, wall));
        EXPECT_TRUE(world.duplicates(world.right, wall));
        EXPECT_FALSE(world.isClustered(wall));
        EXPECT_FALSE(world.oneTask(world.left, world.right)) << "the wall no longer joins them";
    }
}

// A post in the middle shares no cell; a robot that comes near is tested with it, the other is not.
TEST(CrossoverStatics, AStaticGeomBetweenTwoClustersIsTestedWithWhoComesNear) {
    for (const char *pass : {"static", "static-unmerged", "duplication", "decluster"}) {
        TwoRobots world(pass);
        const dGeomID post = world.wall(0, 0, 0, 1);
        const bool duplicates = pass[0] == 'd';
        const auto testedWith = [&](dGeomID robot) {
            return duplicates ? world.duplicates(robot, post) : world.pseudoMerges(robot, post);
        };
        EXPECT_EQ(world.collide(), 0u);
        EXPECT_FALSE(testedWith(world.left)) << pass;
        EXPECT_FALSE(testedWith(world.right)) << pass;
        ClusteredSpace::moveTo(world.left, dReal(-0.9), 0, 0);
        EXPECT_EQ(world.collide(), 1u) << pass << ": met in the frame in which it comes, not in the next";
        EXPECT_TRUE(testedWith(world.left)) << pass;
        EXPECT_FALSE(testedWith(world.right)) << pass;
        ClusteredSpace::moveTo(world.left, -10, 0, 0);
        EXPECT_EQ(world.collide(), 0u);
        EXPECT_FALSE(testedWith(world.left)) << pass << ": and let go";
    }
}

TEST(CrossoverStatics, OverlappingStaticsMergeUnderStaticOnly) {
    const auto build = [](ClusteredSpace &world, dGeomID walls[3]) {
        walls[0] = world.wall(-9, 1, 0, 8);
        walls[1] = world.wall(-2, 1, 0, 8);
        walls[2] = world.wall(10, -1, 0, 1);
        world.collide();
    };
    dGeomID walls[3];
    {
        TwoRobots world("static");
        build(world, walls);
        EXPECT_TRUE(world.together(walls[0], walls[1]));
        EXPECT_FALSE(world.together(walls[0], walls[2]));
        EXPECT_TRUE(world.pseudoMerges(world.left, walls[1])) << "the far end of a merged cluster too";
        EXPECT_FALSE(world.pseudoMerges(world.right, walls[1]));
    }
    {
        TwoRobots world("static-unmerged");
        build(world, walls);
        EXPECT_FALSE(world.together(walls[0], walls[1]));
        EXPECT_EQ(world.clusters().count(), 5);
        EXPECT_TRUE(world.pseudoMerges(world.left, walls[0]));
        EXPECT_FALSE(world.pseudoMerges(world.left, walls[1]));
    }
}

TEST(CrossoverStatics, StaticClustersStayMergedUnderStatic) {
    TwoRobots world("static");
    const dGeomID a = world.wall(-3, 3, 0, 1), b = world.wall(3, 3, 0, 8);
    world.collide();
    EXPECT_TRUE(world.together(a, b));
    ClusteredSpace::moveTo(b, 10, -10, 10);
    world.collide();
    EXPECT_TRUE(world.together(a, b));
}

// A sensor without a body, moved by the program, is static, yet is tested with all geoms, static ones too.
TEST(CrossoverStatics, AMovedGeomWithoutABodyMeetsEverything) {
    for (const char *pass : kPasses) {
        TwoRobots world(pass);
        world.wall(0, 3, 0, 2);
        world.wall(0, -3, 0, 2);
        const dGeomID ray = dCreateRay(world.space(), 1);
        dGeomRaySet(ray, 0, 0, 0, 0, 0, 1);
        EXPECT_EQ(world.collide(), 0u) << pass;
        dGeomRaySet(ray, 0, 3, 0, 0, 0, 1);
        EXPECT_EQ(world.collide(), 1u) << pass << ": a wall";
        dGeomRaySet(ray, 10, 0, 0, 0, 0, 1);
        EXPECT_EQ(world.collide(), 1u) << pass << ": a robot at rest";
        ClusteredSpace::moveTo(world.right, 10, 0, dReal(0.1));
        EXPECT_EQ(world.collide(), 1u) << pass << ": a robot that moves while the ray rests";
    }
}

// The plane reaches down from z = 0. A flyer in the cells above is never tested with it.
TEST(CrossoverStatics, AFlyerIsNotTestedWithTheFloorUnderDuplication) {
    for (const char *pass : {"duplication", "decluster"}) {
        ClusteredSpace world(pass);
        const dGeomID wheels[] = {world.robot(-10, 0, dReal(0.4)), world.robot(10, 0, dReal(0.4))};
        const dGeomID flyer = world.robot(0, 0, 14);
        const dGeomID plane = world.floor(0), slab = world.wall(0, 0, dReal(-0.5), 60, 60);
        EXPECT_EQ(world.collide(), 5u) << "two on plane and slab, and the plane on the slab";
        EXPECT_EQ(world.clustered().scene().big().size(), 2u);
        for (const dGeomID robot : wheels) {
            EXPECT_TRUE(world.duplicates(robot, plane));
            EXPECT_TRUE(world.duplicates(robot, slab));
        }
        EXPECT_TRUE(world.clusterOf(flyer).duplicated.empty());
        ClusteredSpace::moveTo(flyer, 0, 0, dReal(0.4));
        EXPECT_EQ(world.collide(), 7u) << "landed";
        EXPECT_TRUE(world.duplicates(flyer, plane));
    }
}

TEST(CrossoverStatics, OtherPassesKeepTheFloorApart) {
    for (const char *pass : {"original", "static", "static-unmerged"}) {
        ClusteredSpace world(pass);
        const dGeomID robot = world.robot(-10, 0, dReal(0.4)), other = world.robot(10, 0, dReal(0.4));
        const dGeomID plane = world.floor(0);
        EXPECT_EQ(world.collide(), 2u);
        EXPECT_FALSE(world.isClustered(plane));
        EXPECT_FALSE(world.duplicates(robot, plane));
        EXPECT_FALSE(world.oneTask(robot, other)) << "the floor joins no clusters";
    }
}

}  // namespace
