// How each pass merges and splits what moves (thesis 2.2, 8.1). For the cells see crossover_statics_test.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "ClusteredSpace.h"
#include "CrossoverPasses.h"

namespace {

const char *const kSticky[] = {"original", "static", "static-unmerged", "duplication"};

constexpr dReal kInfinitelyFar = std::numeric_limits<dReal>::infinity();

class Crowd : public ClusteredSpace {
public:
    explicit Crowd(const char *pass) : ClusteredSpace(pass) {}
    dGeomID left = robot(-10, 0, 0), right = robot(10, 0, 0), walker = robot(0, 0, 0);
};

TEST(CrossoverCrowd, WhatIsFarApartIsClusteredApart) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        EXPECT_EQ(world.collide(), 0u);
        EXPECT_EQ(world.clusters().dynamicCount(), 3) << pass;
        EXPECT_EQ(world.clustered().entities(), 3) << pass;
    }
}

TEST(CrossoverCrowd, ClustersThatMeetInACellMergeInTheSameFrame) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        world.collide();
        const unsigned left = world.clusterOf(world.left).name, walker = world.clusterOf(world.walker).name;
        ClusteredSpace::moveTo(world.walker, dReal(-9.2), 0, 0);
        EXPECT_EQ(world.collide(), 1u) << pass;
        EXPECT_TRUE(world.together(world.walker, world.left)) << pass;
        EXPECT_FALSE(world.together(world.walker, world.right)) << pass;
        const auto &changes = world.clustered().history().changes();
        ASSERT_EQ(changes.size(), 1u) << pass;
        EXPECT_EQ(changes[0].kind, dxClusterChange::Kind::merge);
        EXPECT_EQ(changes[0].from, walker);
        EXPECT_EQ(changes[0].into, left);
        EXPECT_EQ(world.clusterOf(world.walker).name, left);
        ClusteredSpace::moveTo(world.walker, dReal(-9.19), 0, 0);  // within its cells
        world.collide();
        EXPECT_TRUE(world.clustered().history().changes().empty()) << pass << ": it is reported once";
    }
}

TEST(CrossoverCrowd, WhatHasMergedStaysMergedUnderStickyPasses) {
    for (const char *pass : kSticky) {
        Crowd world(pass);
        for (const int x : {0, -9, 0, 9, 0}) {
            ClusteredSpace::moveTo(world.walker, dReal(x), 0, 0);
            world.collide();
        }
        EXPECT_EQ(world.clusters().dynamicCount(), 1) << pass;
        EXPECT_TRUE(world.together(world.left, world.right)) << pass << ": by way of the walker";
        EXPECT_EQ(world.clustered().history().merges(), 2u) << pass;
        EXPECT_EQ(world.clustered().history().splits(), 0u) << pass;
    }
}

TEST(CrossoverCrowd, DeclusterSplitsWhatHasFallenApart) {
    Crowd world("decluster");
    world.collide();
    const unsigned left = world.clusterOf(world.left).name;
    ClusteredSpace::moveTo(world.walker, -9, 0, 0);
    world.collide();
    EXPECT_TRUE(world.together(world.left, world.walker));
    ClusteredSpace::moveTo(world.walker, 0, 0, 0);
    world.collide();
    EXPECT_EQ(world.clusters().dynamicCount(), 3);
    const auto &changes = world.clustered().history().changes();
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].kind, dxClusterChange::Kind::split);
    EXPECT_EQ(changes[0].from, left);
    EXPECT_EQ(changes[0].into, world.clusterOf(world.walker).name);
    EXPECT_NE(world.clusterOf(world.walker).name, left);
}

// Several groups come off one cluster in one frame.
TEST(CrossoverCrowd, DeclusterSplitsAllGroupsAtOnce) {
    ClusteredSpace world("decluster");
    world.robot(-10, 0, 0);
    world.robot(10, 0, 0);
    dGeomID crowd[4];
    for (int i = 0; i < 4; ++i) crowd[i] = world.robot(dReal(i) / 4 - 1, 0, 0);
    world.collide();
    EXPECT_EQ(world.clusters().count(), 3);
    const dReal places[4][2] = {{0, 0}, {0, 14}, {0, -14}, {12, 12}};
    for (int i = 0; i < 4; ++i) ClusteredSpace::moveTo(crowd[i], places[i][0], places[i][1], 0);
    world.collide();
    EXPECT_EQ(world.clusters().count(), 6);
    EXPECT_EQ(world.clustered().history().splits(), 3u);
}

// Flood fill at the start goes from cell to neighbouring cell; later only geoms that share a cell are clustered.
TEST(CrossoverCrowd, NeighbouringCellsAreOneClusterWhenClustersAreMade) {
    for (const char *pass : kPasses) {
        ClusteredSpace world(pass);
        const dGeomID left = world.robot(-10, 0, 0), right = world.robot(10, 0, 0);
        const dGeomID neighbour = world.robot(-8, 0, 0), diagonal = world.robot(8, 5, 0);
        world.robot(0, -5, 0);  // keeps the grid where it is
        world.collide();
        EXPECT_TRUE(world.together(left, neighbour)) << pass << ": cells 0 and 1";
        EXPECT_FALSE(world.together(right, diagonal)) << pass << ": an edge is no common face";
    }
    for (const char *pass : kPasses) {
        Crowd world(pass);
        world.collide();
        ClusteredSpace::moveTo(world.walker, -8, 0, 0);
        world.collide();
        const bool fillsAnew = std::string(pass) == "decluster";
        EXPECT_EQ(world.together(world.left, world.walker), fillsAnew) << pass;
    }
}

TEST(CrossoverCrowd, AJointedRobotIsOneClusterAcrossCells) {
    for (const char *pass : kPasses) {
        ClusteredSpace world(pass);
        const dGeomID trunk = world.robot(-10, 0, 0), hand = world.robot(10, 0, 0), other = world.robot(0, 12, 0);
        const dJointID joint = world.join(trunk, hand);
        world.collide();
        EXPECT_TRUE(world.together(trunk, hand)) << pass;
        EXPECT_FALSE(world.together(trunk, other)) << pass;
        EXPECT_EQ(world.clustered().entities(), 2) << pass;
        dJointDestroy(joint);
        ClusteredSpace::moveTo(other, dReal(0.5), 12, 0);
        world.collide();
        EXPECT_EQ(world.together(trunk, hand), std::string(pass) != "decluster") << pass;
    }
}

TEST(CrossoverCrowd, AllGeomsOfABodyAreInOneCluster) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        const dGeomID arm = dCreateSphere(world.space(), 1);
        dGeomSetBody(arm, dGeomGetBody(world.left));
        dGeomSetOffsetPosition(arm, 4, 9, 0);
        world.collide();
        EXPECT_TRUE(world.together(world.left, arm)) << pass;
    }
}

// A body-less geom that becomes dynamic is clustered even where only static geoms are.
TEST(CrossoverCrowd, AMovingGeomAmongStaticOnesIsClustered) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        world.wall(0, 10, 0, 1);
        const dGeomID sensor = world.wall(0, 10, dReal(0.5), 1);
        EXPECT_EQ(world.collide(), 1u);
        dGeomSetBody(sensor, dBodyCreate(world.world()));
        ClusteredSpace::moveTo(sensor, 0, 10, dReal(0.5));
        EXPECT_EQ(world.collide(), 1u) << pass;
        EXPECT_TRUE(world.isClustered(sensor)) << pass;
    }
}

// It is in no cell, and a joint to it links no geom.
TEST(CrossoverCrowd, ABodyWithoutGeomsIsNowhere) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        const dBodyID ghost = dBodyCreate(world.world());
        dBodySetPosition(ghost, dReal(1e9), kInfinitelyFar, 0);
        dJointAttach(dJointCreateHinge(world.world(), nullptr), ghost, dGeomGetBody(world.left));
        EXPECT_EQ(world.collide(), 0u) << pass;
        EXPECT_EQ(world.clusters().dynamicCount(), 3) << pass;
        EXPECT_LT(world.clustered().scene().grid().edge(), 10) << pass;
    }
}

// The grid, the other clusters and their names stay what they are.
TEST(CrossoverCrowd, AGeomAddedOrTakenAwayLeavesTheOthersAlone) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        world.collide();
        const auto *const clustered = &world.clustered();
        const unsigned left = world.clusterOf(world.left).name, right = world.clusterOf(world.right).name;
        const dGeomID late = world.robot(0, 12, 0);
        for (int frame = 0; frame < 2; ++frame) {
            world.collide();
            EXPECT_EQ(&world.clustered(), clustered) << pass;
            EXPECT_EQ(world.clusters().dynamicCount(), frame == 0 ? 4 : 3) << pass;
            EXPECT_EQ(world.clusterOf(world.left).name, left) << pass;
            EXPECT_EQ(world.clusterOf(world.right).name, right) << pass;
            EXPECT_TRUE(world.clustered().history().changes().empty()) << pass;
            if (frame == 0) dGeomDestroy(late);
        }
    }
}

TEST(CrossoverCrowd, ABigMovingGeomIsTestedWithAll) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        const dGeomID ship = dCreateBox(world.space(), 40, 40, dReal(0.5));
        dGeomSetBody(ship, dBodyCreate(world.world()));
        EXPECT_EQ(world.collide(), 3u) << pass;
        EXPECT_FALSE(world.isClustered(ship)) << pass;
        ClusteredSpace::moveTo(world.left, -10, 0, dReal(0.3));
        EXPECT_EQ(world.collide(), 3u) << pass;
    }
}

// Nothing is lost by leaving the grid, in the frame of leaving and after.
TEST(CrossoverCrowd, PairsOutsideTheGridAreFound) {
    for (const char *pass : kPasses) {
        Crowd world(pass);
        world.wall(500, 500, 0, 1, 1);
        world.collide();
        for (int frame = 0; frame < 40; ++frame) {
            ClusteredSpace::moveTo(world.walker, 500, 500, dReal(frame) / 100);
            ASSERT_EQ(world.collide(), 1u) << pass << ", frame " << frame;
        }
        EXPECT_GT(world.clustered().scene().grid().edge(), 30) << pass << ": and the grid follows";
    }
}

}  // namespace
