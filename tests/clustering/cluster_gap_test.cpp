// dxClusterGap: nothing that a cluster is not tested with is nearer than the gap says.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "CrossoverPasses.h"
#include "bounds.h"
#include "clusters/dxClusterGap.h"

namespace {

using Kind = dxClusterScene::Kind;
using Slot = dxMembers::Slot;

constexpr double kInf = std::numeric_limits<double>::infinity();

// A grid of 10 cells of 10 m around the origin; cubes of 1 m by their centre.
class ClusterGap : public testing::Test {
protected:
    ClusterGap() {
        const dReal centre[3] = {0, 0, 0};
        scene.setGrid(dxClusterGrid(10, 10, centre));
    }
    Slot add(Kind kind, dReal x, dReal y = 5, dReal z = 5) {
        scene.put(next, kind, cubeAt(x, y, z));
        return next++;
    }
    Slot robot(dReal x, dReal y = 5) { return add(Kind::dynamicGeom, x, y); }
    Slot wall(dReal x, dReal y = 5) { return add(Kind::staticGeom, x, y); }

    double gap(const char *name) {
        pass = dxMakeCrossoverPass(name);
        clusters.clear(scene.end());
        pass->cross(scene, links, dxClusters(), clusters);
        return measured.toOthers(scene, clusters, *pass);
    }

    dxClusterScene scene;
    dxClusters clusters;
    dxClusterGap measured;
    std::unique_ptr<dxCrossoverPass> pass;
    std::vector<dxCrossoverPass::Link> links;
    Slot next = 0;
};

TEST_F(ClusterGap, OneClusterThatIsTestedWithAllHasNoOthers) {
    robot(2);
    robot(4);
    for (const char *name : {"original", "duplication"}) EXPECT_EQ(gap(name), kInf) << name;
    wall(6);
    for (const char *name : kPasses)
        EXPECT_EQ(gap(name), kInf) << name;
}

TEST_F(ClusterGap, IsHalfACellAtMost) {
    robot(-15);
    robot(5);
    EXPECT_EQ(gap("original"), 5) << "nothing is looked for beyond a cell, and half of one is sure";
}

TEST_F(ClusterGap, CountsAStaticGeomThatIsListedElsewhereOrNowhere) {
    robot(5);
    wall(13);
    EXPECT_EQ(gap("original"), kInf) << "tested with all";
    for (const char *name : {"static", "static-unmerged", "duplication", "decluster"})
        EXPECT_NEAR(gap(name), 5, 1e-9) << name << ": 7 m away, and nothing is looked for beyond half a cell";
    wall(11);
    for (const char *name : {"static-unmerged", "duplication"}) EXPECT_NEAR(gap(name), 5, 1e-9) << name;
    robot(-33);
    wall(dReal(9.1), dReal(10.7));
    EXPECT_NEAR(gap("duplication"), 4.7, 1e-6) << "by y, where the boxes are further apart than by x";
}

TEST_F(ClusterGap, IsNeverAboveTheTrueDistance) {
    for (dReal x = dReal(0.6); x < 4; x += dReal(0.0713)) {
        next = 0;
        scene.put(next++, Kind::dynamicGeom, cubeAt(x, 5, 5));
        scene.put(next++, Kind::staticGeom, cubeAt(dReal(-3.3), 5, 5));
        const long double distance = static_cast<long double>(scene[0].bounds.low(0)) - scene[1].bounds.high(0);
        EXPECT_LE(static_cast<long double>(gap("duplication")), distance);
        EXPECT_GT(gap("duplication"), 0.9 * std::min<double>(5, static_cast<double>(distance)));
    }
}

TEST_F(ClusterGap, WhereBoxesAroundClustersMeetItIsZero) {
    links = {{robot(-35, -35), robot(35, 35)}};
    robot(35, -35);
    EXPECT_EQ(gap("original"), 0);
}

TEST_F(ClusterGap, ABoxWithNaNOverlapsOnThatAxisOnly) {
    robot(5);
    scene.put(next++, Kind::staticGeom, boundsOf(kNaN, 1, 40, 41, 40, 41));
    scene.put(next++, Kind::staticGeom, boundsOf(-kInfinite, kInfinite, -kInfinite, kInfinite, -kInfinite, dReal(-0.1)));
    EXPECT_NEAR(gap("duplication"), 4.6, 1e-6) << "down to the floor";
}

TEST_F(ClusterGap, ARobotAloneIsNeverCut) {
    links = {{robot(5), robot(15)}};
    gap("decluster");
    EXPECT_EQ(dxGapBeforeCut(scene, clusters, links), kInf);
}

TEST_F(ClusterGap, ThereIsRoomBeforeACutUpToTheNextCell) {
    robot(5);
    robot(8);  // its upper bound 8.5 may go up by 1.5 m
    gap("decluster");
    EXPECT_NEAR(dxGapBeforeCut(scene, clusters, links), 2 * 1.5, 1e-6);
    robot(49);  // in the border cell, alone
    gap("decluster");
    EXPECT_NEAR(dxGapBeforeCut(scene, clusters, links), 2 * 1.5, 1e-6);
}

}  // namespace
