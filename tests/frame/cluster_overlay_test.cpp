// What a debug overlay can see of clusters (ode_MT.h, group ode_mt_clusters).
//
// Covers api/ode_MT_clusters.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <csignal>
#include <vector>

#include "OdeSession.h"

namespace {

class ClusterOverlay : public testing::Test {
protected:
    ClusterOverlay() {
        dODE_MT_SetAlgorithm("decluster");
        world = dWorldCreate();
        space = dSimpleSpaceCreate(nullptr);
        floor = dCreatePlane(space, 0, 0, 1, 0);
        for (int i = 0; i < 4; ++i) balls[i] = ball(i < 2 ? i : 100 + i);
        collide();
    }

    ~ClusterOverlay() override {
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dODE_MT_SetAlgorithm("auto");
    }

    dGeomID ball(dReal x) {
        const dGeomID geom = dCreateSphere(space, 1);
        dGeomSetBody(geom, dBodyCreate(world));
        dGeomSetPosition(geom, x, 0, 1);
        return geom;
    }

    dGeomID box(dReal x) {
        const dGeomID geom = dCreateBox(space, 1, 1, 1);
        dGeomSetPosition(geom, x, 0, 1);
        return geom;
    }

    std::vector<unsigned> testedWith(dGeomID geom) {
        std::vector<unsigned> names(static_cast<std::size_t>(dClusterGetTestedWith(geom, nullptr, 0)));
        dClusterGetTestedWith(geom, names.data(), static_cast<int>(names.size()));
        return names;
    }

    void collide() {
        dSpaceCollide(space, nullptr, [](void *, dGeomID, dGeomID) {});
    }

    std::vector<dClusterEvent> events() {
        std::vector<dClusterEvent> all(16);
        all.resize(static_cast<std::size_t>(dClusterGetEvents(world, space, all.data(), 16)));
        return all;
    }

    OdeSession session;
    dWorldID world;
    dSpaceID space;
    dGeomID floor, balls[4];
};

TEST_F(ClusterOverlay, TellsClustersOfGeomsAndBodies) {
    EXPECT_EQ(dClusterGetCount(world, space), 2);
    EXPECT_NE(dClusterGetOfGeom(balls[0]), 0u);
    EXPECT_EQ(dClusterGetOfGeom(balls[0]), dClusterGetOfGeom(balls[1]));
    EXPECT_NE(dClusterGetOfGeom(balls[0]), dClusterGetOfGeom(balls[2]));
    EXPECT_EQ(dClusterGetOfBody(dGeomGetBody(balls[2])), dClusterGetOfGeom(balls[2]));
    EXPECT_EQ(dClusterGetOfGeom(floor), 0u) << "static";
    const dBodyID bare = dBodyCreate(world);
    EXPECT_EQ(dClusterGetOfBody(bare), 0u) << "without a geom";
}

TEST_F(ClusterOverlay, TellsTheGridAndItsCells) {
    EXPECT_EQ(dClusterGetGridCells(world, space), 5);
    EXPECT_GT(dClusterGetGridStep(world, space), 100 / 5);
    float x = 0, y = 0, z = 0;
    dClusterGetCenter(world, space, &x, &y, &z);
    EXPECT_NEAR(x, 51.5, 1);
    dClusterCell cells[8];
    const int count = dClusterGetCells(world, space, cells, 8);
    ASSERT_GE(count, 2);
    ASSERT_LE(count, 8);
    for (const dGeomID geom : balls)
        EXPECT_TRUE(std::any_of(cells, cells + count, [&](const dClusterCell &cell) {
            return cell.cluster == dClusterGetOfGeom(geom) && cell.x < 5 && cell.y < 5 && cell.z < 5;
        }));
    EXPECT_EQ(dClusterGetCells(world, space, nullptr, 0), count);
}

TEST_F(ClusterOverlay, TellsWithWhichClustersAGeomIsTested) {
    const dGeomID near = box(0), between = box(51);
    collide();
    const unsigned first = dClusterGetOfGeom(balls[0]), second = dClusterGetOfGeom(balls[2]);
    EXPECT_EQ(testedWith(balls[0]), (std::vector<unsigned>{first}));
    EXPECT_EQ(testedWith(near), (std::vector<unsigned>{first}));
    EXPECT_EQ(testedWith(between), std::vector<unsigned>());
    EXPECT_EQ(testedWith(floor).size(), 2u);
    EXPECT_NE(first, second);
    unsigned one = 0;
    EXPECT_EQ(dClusterGetTestedWith(floor, &one, 1), 2) << "there are more than fit";
    EXPECT_TRUE(one == first || one == second);
}

TEST_F(ClusterOverlay, TellsThatStaticsApartAreTestedWithAll) {
    dODE_MT_SetAlgorithm("original");
    const dGeomID between = box(51);
    collide();
    EXPECT_EQ(testedWith(between).size(), 2u);
    EXPECT_EQ(dClusterGetStaticOfGeom(between), 0u);
}

TEST_F(ClusterOverlay, TellsClustersOfStaticGeoms) {
    EXPECT_EQ(dClusterGetStaticOfGeom(box(0)), 0u) << "not under decluster";
    dODE_MT_SetAlgorithm("static");
    const dGeomID near = box(0.5), between = box(51);
    collide();
    EXPECT_NE(dClusterGetStaticOfGeom(near), 0u);
    EXPECT_NE(dClusterGetStaticOfGeom(between), 0u);
    EXPECT_NE(dClusterGetStaticOfGeom(near), dClusterGetStaticOfGeom(between));
    EXPECT_EQ(dClusterGetStaticOfGeom(balls[0]), 0u) << "it moves";
    EXPECT_EQ(dClusterGetOfGeom(near), 0u);
    EXPECT_EQ(testedWith(near), (std::vector<unsigned>{dClusterGetOfGeom(balls[0])}));
    EXPECT_EQ(testedWith(between), std::vector<unsigned>());
}

TEST_F(ClusterOverlay, AFixedGridStaysAsItIs) {
    dODE_MT_SetGridCells(9);
    for (int frame = 0; frame < 100; ++frame) {
        dGeomSetPosition(balls[0], 0, 0, 1);
        collide();
        ASSERT_EQ(dClusterGetGridCells(world, space), 9) << "frame " << frame;
    }
    dODE_MT_SetGridCells(0);
}

TEST_F(ClusterOverlay, TellsMergesAndSplits) {
    const unsigned kept = dClusterGetOfGeom(balls[0]), lost = dClusterGetOfGeom(balls[3]);
    collide();
    EXPECT_TRUE(events().empty()) << "nothing moved";
    dGeomSetPosition(balls[2], 2, 0, 1);
    dGeomSetPosition(balls[3], 3, 0, 1);
    collide();
    ASSERT_EQ(events().size(), 1u);
    EXPECT_EQ(events()[0].isSplit, 0);
    EXPECT_EQ(std::min(events()[0].from, events()[0].into), std::min(kept, lost));
    EXPECT_EQ(std::max(events()[0].from, events()[0].into), std::max(kept, lost));
    EXPECT_EQ(dClusterGetCount(world, space), 1);
    dGeomSetPosition(balls[3], 103, 0, 1);
    collide();
    ASSERT_EQ(events().size(), 1u);
    EXPECT_EQ(events()[0].isSplit, 1);
    EXPECT_EQ(events()[0].into, dClusterGetOfGeom(balls[3]));
}

TEST_F(ClusterOverlay, TellsEventsOnce) {
    dGeomSetPosition(balls[2], 2, 0, 1);
    dGeomSetPosition(balls[3], 3, 0, 1);
    collide();
    EXPECT_FALSE(events().empty());
    for (int i = 0; i < 3; ++i) {
        collide();
        EXPECT_TRUE(events().empty()) << "nothing moved";
    }
}

// Slots of geoms that have gone are given again.
TEST_F(ClusterOverlay, NewGeomsAreInNoneUntilTheNextCollision) {
    dBodyDestroy(dGeomGetBody(balls[3]));
    dGeomDestroy(balls[3]);
    const dGeomID apart = box(-500), near = ball(0.5);
    for (const dGeomID geom : {apart, near}) {
        EXPECT_EQ(dClusterGetOfGeom(geom), 0u);
        EXPECT_EQ(dClusterGetTestedWith(geom, nullptr, 0), 0);
        EXPECT_EQ(dClusterGetStaticOfGeom(geom), 0u);
    }
    collide();
    EXPECT_EQ(dClusterGetOfGeom(near), dClusterGetOfGeom(balls[0]));
    EXPECT_EQ(dClusterGetOfGeom(apart), 0u);
}

TEST_F(ClusterOverlay, NamesOutlastTheGrid) {
    const unsigned first = dClusterGetOfGeom(balls[0]), second = dClusterGetOfGeom(balls[2]);
    const int cells = dClusterGetGridCells(world, space);
    for (int frame = 0; frame < 400 && dClusterGetGridCells(world, space) == cells; ++frame) {
        dGeomSetPosition(balls[0], 0, 0, 1);
        collide();
    }
    EXPECT_NE(dClusterGetGridCells(world, space), cells) << "the cell size heuristic tried no other grid";
    EXPECT_EQ(dClusterGetOfGeom(balls[0]), first);
    EXPECT_EQ(dClusterGetOfGeom(balls[2]), second);
}

TEST_F(ClusterOverlay, IsGoneWithTheAlgorithm) {
    dODE_MT_SetAlgorithm("auto");
    collide();
    EXPECT_EQ(dClusterGetCount(world, space), 1);
    EXPECT_EQ(dClusterGetOfGeom(balls[0]), 0u);
    EXPECT_EQ(dClusterGetGridCells(world, space), 0);
    EXPECT_EQ(dClusterGetEvents(world, space, nullptr, 0), 0);
    EXPECT_EQ(dClusterGetTestedWith(balls[0], nullptr, 0), 0);
}

TEST_F(ClusterOverlay, BadArgumentsAreNamed) {
    const testing::KilledBySignal aborted(SIGABRT);
    EXPECT_EXIT(dClusterGetGridCells(nullptr, space), aborted, "bad world argument in dClusterGetGridCells");
    EXPECT_EXIT(dClusterGetGridCells(world, reinterpret_cast<dSpaceID>(balls[0])), aborted, "bad space argument");
    EXPECT_EXIT(dClusterGetOfGeom(nullptr), aborted, "bad geom argument");
    EXPECT_EXIT(dClusterGetOfBody(nullptr), aborted, "bad body argument");
    EXPECT_EXIT(dClusterGetStaticOfGeom(nullptr), aborted, "bad geom argument in dClusterGetStaticOfGeom");
    EXPECT_EXIT(dClusterGetTestedWith(nullptr, nullptr, 0), aborted, "bad geom argument in dClusterGetTestedWith");
    EXPECT_EXIT(dClusterGetTestedWith(balls[0], nullptr, 1), aborted, "bad clusters argument");
    EXPECT_EXIT(dClusterGetCells(world, space, nullptr, 1), aborted, "bad cells argument");
    EXPECT_EXIT(dClusterGetEvents(world, space, nullptr, 1), aborted, "bad events argument");
}

}  // namespace
