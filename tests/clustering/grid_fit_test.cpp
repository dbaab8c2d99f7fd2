// dxFitGrid and dxGridIsOutgrown: the grid goes around what moves.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bounds.h"
#include "clusters/dxClusterScene.h"

namespace {

using Kind = dxClusterScene::Kind;

class GridFit : public testing::Test {
protected:
    GridFit() { scene.setGrid(dxClusterGrid()); }

    void add(Kind kind, const dxBounds &box) { scene.put(next++, kind, box); }
    void addDynamic(dReal x, dReal y = 0, dReal z = 0) { add(Kind::dynamicGeom, cubeAt(x, y, z)); }
    void addRow(int count, dReal from, dReal to) {
        for (int i = 0; i < count; ++i) addDynamic(from + (to - from) * dReal(i) / dReal(count - 1));
    }
    // The length of the grid's side.
    dReal fittedLength(int cells = 10) const {
        const dxClusterGrid grid = dxFitGrid(scene, cells);
        return grid.edge() * dReal(grid.cells());
    }
    void fit() { scene.setGrid(dxFitGrid(scene, 10)); }

    dxClusterScene scene;
    dxClusterScene::Slot next = 0;
};

TEST_F(GridFit, GoesAroundTheLongestAxisWithRoom) {
    addDynamic(-10, 7, 3);
    addDynamic(10, 7, 5);
    const dxClusterGrid grid = dxFitGrid(scene, 8);
    EXPECT_EQ(grid.cells(), 8);
    EXPECT_NEAR(grid.edge() * 8, 21 * 1.5, 1e-4);
    EXPECT_NEAR(grid.centre()[0], 0, 1e-6);
    EXPECT_NEAR(grid.centre()[1], 7, 1e-6);
    EXPECT_NEAR(grid.centre()[2], 4, 1e-6);
}

TEST_F(GridFit, StaticGeomsDoNotStretchIt) {
    addRow(10, -10, 10);
    const dReal length = fittedLength();
    add(Kind::staticGeom, boundsOf(-5000, 5000, -5000, 5000, -1, 0));
    add(Kind::staticGeom, cubeAt(99999, 0, 0));
    EXPECT_EQ(fittedLength(), length);
}

TEST_F(GridFit, AFewStraysDoNotStretchIt) {
    addRow(100, -10, 10);
    const dReal length = fittedLength();
    addDynamic(1000);
    addDynamic(-5000);
    EXPECT_LE(fittedLength(), length * dReal(1.05));
    addRow(5, 1000, 1010);  // more than a few
    EXPECT_GT(fittedLength(), 1000);
}

TEST_F(GridFit, BoxesThatAreNotProperDoNotCount) {
    addRow(10, -10, 10);
    const dReal length = fittedLength();
    add(Kind::dynamicGeom, boundsOf(-kInfinite, kInfinite, 0, 1, 0, 1));
    add(Kind::dynamicGeom, boundsOf(0, 1, kNaN, 1, 0, 1));
    EXPECT_EQ(fittedLength(), length);
}

// A scene wholly beyond any "usual" number is like one around the origin.
TEST_F(GridFit, PlacesFarFromTheOriginAreFitted) {
    addDynamic(5000, 5000, 5000);
    addDynamic(5010, 5000, 5000);
    const dxClusterGrid grid = dxFitGrid(scene, 5);
    EXPECT_NEAR(grid.edge() * 5, 11 * 1.5, 1e-2);
    EXPECT_NEAR(grid.centre()[0], 5005, 1e-2);
}

TEST_F(GridFit, HasAUsableEdgeWhateverThereIs) {
    const auto usable = [&] {
        const dxClusterGrid grid = dxFitGrid(scene, 20);
        return std::isfinite(grid.edge()) && grid.edge() > 0;
    };
    using Limits = std::numeric_limits<dReal>;
    EXPECT_TRUE(usable()) << "empty";
    add(Kind::dynamicGeom, cubeAt(1, 2, 3, 0));
    EXPECT_TRUE(usable()) << "a point";
    scene.put(0, Kind::dynamicGeom, boundsOf(0, Limits::denorm_min(), 0, 0, 0, 0));
    EXPECT_TRUE(usable()) << "a denormal length";
    scene.put(0, Kind::dynamicGeom, boundsOf(0, Limits::max() * dReal(0.9), 0, 0, 0, 0));
    EXPECT_TRUE(usable()) << "too long for the room";
    scene.put(0, Kind::dynamicGeom, boundsOf(-Limits::max(), Limits::max(), 0, 0, 0, 0));
    EXPECT_TRUE(usable()) << "no difference exists";
}

TEST_F(GridFit, IsOutgrownWhenMoreAreOutsideThanStraysMayBe) {
    addRow(40, -10, 10);
    fit();
    EXPECT_FALSE(dxGridIsOutgrown(scene));
    for (dxClusterScene::Slot slot = 0; slot < 4; ++slot) scene.put(slot, Kind::dynamicGeom, cubeAt(500, 0, 0));
    EXPECT_FALSE(dxGridIsOutgrown(scene));
    scene.put(4, Kind::dynamicGeom, cubeAt(500, 0, 0));
    EXPECT_TRUE(dxGridIsOutgrown(scene));
    fit();
    EXPECT_FALSE(dxGridIsOutgrown(scene));
}

TEST_F(GridFit, IsNotOutgrownByStaticGeomsOrByNone) {
    EXPECT_FALSE(dxGridIsOutgrown(scene));
    for (int i = 0; i < 10; ++i) add(Kind::staticGeom, cubeAt(500, 0, 0));
    EXPECT_FALSE(dxGridIsOutgrown(scene));
}

// Otherwise the grid would be replaced repeatedly, and the clusters with it.
TEST_F(GridFit, AFittedGridIsNotOutgrownEvenWithStraysOnAllSides) {
    std::mt19937 random(4);
    std::cauchy_distribution<double> heavyTails(0, 1);
    for (int seed = 0; seed < 200; ++seed) {
        scene = dxClusterScene();
        scene.setGrid(dxClusterGrid());
        next = 0;
        for (int i = 0; i < 300; ++i)
            addDynamic(dReal(heavyTails(random)), dReal(heavyTails(random)), dReal(heavyTails(random)));
        fit();
        ASSERT_FALSE(dxGridIsOutgrown(scene)) << "seed " << seed;
    }
}

}  // namespace
