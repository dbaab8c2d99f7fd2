// dxClusterScene: the geoms of each cell, updated by changes, against a scene that is built from scratch.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bounds.h"
#include "clusters/dxClusterScene.h"

namespace {

using Slot = dxClusterScene::Slot;
using Kind = dxClusterScene::Kind;

constexpr Kind kDynamic = Kind::dynamicGeom, kStatic = Kind::staticGeom;
const dReal kOrigin[3] = {0, 0, 0};

template <class T>
std::vector<T> sorted(std::vector<T> values) {
    std::sort(values.begin(), values.end());
    return values;
}

class ClusterScene : public testing::Test {
protected:
    ClusterScene() { scene.setGrid(dxClusterGrid(5, 2, kOrigin)); }

    int cellAt(dReal x, dReal y, dReal z) const {
        const dxCellRange range = scene.grid().cellsOf(cubeAt(x, y, z, 0));
        return scene.grid().index(range.low[0], range.low[1], range.low[2]);
    }

    dxClusterScene scene;
};

TEST_F(ClusterScene, APutInhabitantIsInItsCellsAndInTheListOfItsKind) {
    scene.put(3, kDynamic, cubeAt(-2, 0, 0, 2));
    scene.put(1, kStatic, cubeAt(0, 0, 0));
    EXPECT_EQ(scene.in(cellAt(-2, 0, 0), kDynamic), std::vector<Slot>{3});
    EXPECT_EQ(scene.in(cellAt(0, 0, 0), kDynamic), std::vector<Slot>{3});  // reaches over the border
    EXPECT_EQ(scene.in(cellAt(0, 0, 0), kStatic), std::vector<Slot>{1});
    EXPECT_EQ(scene.all(kDynamic), std::vector<Slot>{3});
    EXPECT_EQ(scene.all(kStatic), std::vector<Slot>{1});
    EXPECT_TRUE(scene.big().empty());
}

TEST_F(ClusterScene, OccupiedCellsAreThoseWithDynamics) {
    scene.put(0, kDynamic, cubeAt(-2, 0, 0, 2));
    scene.put(1, kDynamic, cubeAt(0, 0, 0));
    scene.put(2, kStatic, cubeAt(4, 4, 4));
    EXPECT_EQ(scene.occupied().size(), 8u);
    scene.remove(0);
    EXPECT_EQ(scene.occupied(), std::vector<int>{cellAt(0, 0, 0)});
    scene.remove(1);
    EXPECT_TRUE(scene.occupied().empty());
}

TEST_F(ClusterScene, ChangesCountComingGoingOtherCellsAndOtherKindOnly) {
    const auto changesOf = [&](auto action) {
        const unsigned before = scene.changes();
        action();
        return scene.changes() - before;
    };
    EXPECT_GT(changesOf([&] { scene.put(0, kDynamic, cubeAt(0, 0, 0)); }), 0u);
    EXPECT_EQ(changesOf([&] { scene.put(0, kDynamic, cubeAt(dReal(0.3), 0, 0)); }), 0u);
    EXPECT_GT(changesOf([&] { scene.put(0, kDynamic, cubeAt(dReal(0.7), 0, 0)); }), 0u);
    EXPECT_GT(changesOf([&] { scene.put(0, kStatic, cubeAt(dReal(0.7), 0, 0)); }), 0u);
    EXPECT_GT(changesOf([&] { scene.remove(0); }), 0u);
    EXPECT_EQ(changesOf([&] { scene.remove(0); }), 0u);
    EXPECT_EQ(changesOf([&] { scene.remove(77); }), 0u);
}

TEST_F(ClusterScene, TheBoxIsTheLastOneAlsoWithinTheSameCells) {
    scene.put(0, kDynamic, cubeAt(0, 0, 0));
    scene.put(0, kDynamic, cubeAt(dReal(0.25), 0, 0));
    EXPECT_EQ(scene[0].bounds.v[0], dReal(-0.25));
}

TEST_F(ClusterScene, AFloorIsBigAndAWallAlongTheGridIsNot) {
    scene.put(0, kStatic, boundsOf(-5, 5, -5, 5, dReal(-0.5), dReal(0.5)));
    scene.put(1, kStatic, boundsOf(-5, 5, dReal(-0.5), dReal(0.5), -1, dReal(2.9)));
    EXPECT_TRUE(scene[0].big);
    EXPECT_FALSE(scene[1].big);
    EXPECT_EQ(scene.big(), std::vector<Slot>{0});
    EXPECT_EQ(scene.all(kStatic), std::vector<Slot>{1});
    EXPECT_TRUE(scene.in(cellAt(4, 4, 0), kStatic).empty());
}

TEST_F(ClusterScene, BoxesThatAreNotProperAreBig) {
    scene.put(0, kDynamic, boundsOf(0, kInfinite, 0, 1, 0, 1));
    scene.put(1, kDynamic, boundsOf(0, 1, kNaN, 1, 0, 1));
    scene.put(2, kStatic, boundsOf(0, 1, 0, 1, 1, 0));
    EXPECT_EQ(sorted(scene.big()), (std::vector<Slot>{0, 1, 2}));
    EXPECT_TRUE(scene.occupied().empty());
    scene.put(0, kDynamic, cubeAt(0, 0, 0));  // and back
    EXPECT_EQ(sorted(scene.big()), (std::vector<Slot>{1, 2}));
    EXPECT_EQ(scene.all(kDynamic), std::vector<Slot>{0});
}

TEST_F(ClusterScene, ANewGridPlacesEverybodyAnew) {
    scene.put(0, kDynamic, cubeAt(0, 0, 0));
    scene.put(1, kDynamic, cubeAt(30, 0, 0));
    scene.put(2, kStatic, cubeAt(-3, -3, 0, 4));
    scene.put(3, kStatic, cubeAt(4, 4, 4));
    scene.remove(3);
    const dReal centre[3] = {20, 0, 0};
    scene.setGrid(dxClusterGrid(10, 5, centre));
    EXPECT_EQ(scene.in(cellAt(30, 0, 0), kDynamic), std::vector<Slot>{1});
    EXPECT_EQ(sorted(scene.all(kDynamic)), (std::vector<Slot>{0, 1}));
    EXPECT_EQ(scene.all(kStatic), std::vector<Slot>{2});
}

struct Entry {
    Kind kind = Kind::none;
    dxBounds bounds = cubeAt(0, 0, 0);
};

void expectSame(const dxClusterScene &scene, const std::vector<Entry> &entries) {
    dxClusterScene anew;
    anew.setGrid(scene.grid());
    for (Slot slot = 0; slot < entries.size(); ++slot)
        if (entries[slot].kind != Kind::none) anew.put(slot, entries[slot].kind, entries[slot].bounds);
    EXPECT_EQ(sorted(scene.big()), sorted(anew.big()));
    EXPECT_EQ(sorted(scene.occupied()), sorted(anew.occupied()));
    for (const Kind kind : {kDynamic, kStatic}) {
        EXPECT_EQ(sorted(scene.all(kind)), sorted(anew.all(kind)));
        for (int cell = 0; cell < scene.grid().cellCount(); ++cell)
            ASSERT_EQ(sorted(scene.in(cell, kind)), sorted(anew.in(cell, kind))) << "cell " << cell;
    }
}

TEST_F(ClusterScene, AfterManyChangesItIsAsIfMadeAnew) {
    std::mt19937 random(2);
    const auto uniform = [&](dReal low, dReal high) {
        return std::uniform_real_distribution<dReal>(low, high)(random);
    };
    std::vector<Entry> entries(30);
    for (int round = 0; round < 3000; ++round) {
        const Slot slot = random() % entries.size();
        if (random() % 5 == 0) {
            entries[slot].kind = Kind::none;
            scene.remove(slot);
        } else {
            const dReal edge = random() % 10 == 0 ? 20 : uniform(0, 3);
            entries[slot] = {random() % 2 == 0 ? kDynamic : kStatic,
                             cubeAt(uniform(-8, 8), uniform(-8, 8), uniform(-8, 8), edge)};
            if (random() % 20 == 0) entries[slot].bounds.v[random() % 6] = kInfinite;
            scene.put(slot, entries[slot].kind, entries[slot].bounds);
        }
        if (random() % 100 == 0) scene.setGrid(dxClusterGrid(3 + random() % 6, uniform(1, 4), kOrigin));
        if (round % 50 == 0) expectSame(scene, entries);
        if (HasFailure()) return;
    }
}

}  // namespace
