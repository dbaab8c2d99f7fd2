// dxClusterGrid: which cells a box covers, and that no overlapping pair is ever without a common cell.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "bounds.h"
#include "clusters/dxClusterGrid.h"

namespace {

const dReal kOrigin[3] = {0, 0, 0};

// Cells of edge 2 from -5 to 5: 0 is [-5, -3), 4 is [3, 5].
dxClusterGrid smallGrid() { return dxClusterGrid(5, 2, kOrigin); }

void expectCells(const dxCellRange &range, int axis, int low, int high) {
    EXPECT_EQ(range.low[axis], low);
    EXPECT_EQ(range.high[axis], high);
}

bool share(const dxCellRange &a, const dxCellRange &b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
    return true;
}

TEST(ClusterGrid, ABoxCoversTheCellsOfItsBounds) {
    const dxCellRange range = smallGrid().cellsOf(boundsOf(-4, dReal(-3.5), -1, dReal(0.9), dReal(0.5), dReal(4.5)));
    expectCells(range, 0, 0, 0);
    expectCells(range, 1, 2, 2);
    expectCells(range, 2, 2, 4);
    EXPECT_EQ(range.count(), 3);
}

TEST(ClusterGrid, ABoundOnABorderBelongsToTheCellAbove) {
    expectCells(smallGrid().cellsOf(cubeAt(-2, 0, 0, 2)), 0, 1, 2);  // -3 to -1
}

TEST(ClusterGrid, WhatLiesOutsideBelongsToTheBorderCells) {
    const dxClusterGrid grid = smallGrid();
    expectCells(grid.cellsOf(cubeAt(-1000, 0, 0)), 0, 0, 0);
    expectCells(grid.cellsOf(cubeAt(0, 1000, 0)), 1, 4, 4);
    expectCells(grid.cellsOf(boundsOf(-kInfinite, kInfinite, 0, 1, kInfinite, kInfinite)), 0, 0, 4);
    expectCells(grid.cellsOf(boundsOf(-kInfinite, kInfinite, 0, 1, kInfinite, kInfinite)), 2, 4, 4);
    expectCells(grid.cellsOf(cubeAt(dReal(1e30), 0, 0)), 0, 4, 4);
}

// Such a box overlaps everything on the axis, or has to be compared with everything.
TEST(ClusterGrid, NaNAndInvertedBoxesCoverTheWholeAxis) {
    const dxClusterGrid grid = smallGrid();
    expectCells(grid.cellsOf(boundsOf(kNaN, 0, 0, 0, 0, 0)), 0, 0, 4);
    expectCells(grid.cellsOf(boundsOf(0, 0, 0, kNaN, 0, 0)), 1, 0, 4);
    expectCells(grid.cellsOf(boundsOf(0, 0, 0, 0, 1, -1)), 2, 0, 4);
    expectCells(grid.cellsOf(boundsOf(0, 0, 0, 0, 1, -1)), 0, 2, 2);
}

// Only the border lies where a difference of coordinates is no number; x86 turns that into a cell by luck.
TEST(ClusterGrid, BoundsForWhichNoDifferenceExistsHaveACell) {
    const dReal farAway[3] = {-std::numeric_limits<dReal>::max(), 0, 0};
    const dxClusterGrid grid(5, std::numeric_limits<dReal>::max() / 5, farAway);
    expectCells(grid.cellsOf(boundsOf(-kInfinite, 0, 0, 1, 0, 1)), 0, 0, 4);
}

TEST(ClusterGrid, IsLeftOnAnySide) {
    const dxClusterGrid grid = smallGrid();
    EXPECT_FALSE(grid.isLeftBy(boundsOf(-5, 5, -5, 5, -5, 5)));
    for (int bound = 0; bound < 6; ++bound) {
        dxBounds box = cubeAt(0, 0, 0);
        box.v[bound] = bound % 2 == 0 ? dReal(-5.1) : dReal(5.1);
        EXPECT_TRUE(grid.isLeftBy(box)) << "bound " << bound;
        box.v[bound] = kNaN;
        EXPECT_TRUE(grid.isLeftBy(box)) << "bound " << bound;
    }
}

TEST(ClusterGrid, CellsAreNumberedWithoutGapsOrRepeats) {
    const dxClusterGrid grid = smallGrid();
    std::set<int> numbers;
    grid.forCells(grid.cellsOf(boundsOf(-9, 9, -9, 9, -9, 9)), [&](int cell) { numbers.insert(cell); });
    EXPECT_EQ(static_cast<int>(numbers.size()), grid.cellCount());
    EXPECT_EQ(*numbers.begin(), 0);
    EXPECT_EQ(*numbers.rbegin(), grid.cellCount() - 1);
}

// Sizes and places over many decades, most outside of the grid; some bounds NaN, infinite or inverted.
TEST(ClusterGrid, OverlappingBoxesAlwaysShareACell) {
    std::mt19937 random(1);
    const auto uniform = [&](dReal low, dReal high) {
        return std::uniform_real_distribution<dReal>(low, high)(random);
    };
    const auto odd = [&](dReal value) {
        switch (random() % 60) {
        case 0: return kNaN;
        case 1: return kInfinite;
        case 2: return -kInfinite;
        default: return value;
        }
    };
    int overlapping = 0;
    for (int round = 0; round < 100000; ++round) {
        const dReal centre[3] = {uniform(-9, 9), uniform(-9, 9), uniform(-9, 9)};
        const dxClusterGrid grid(5 + static_cast<int>(random() % 16), std::pow(dReal(10), uniform(-3, 3)), centre);
        dxBounds boxes[2];
        for (dxBounds &box : boxes) {
            const dReal reach = std::pow(dReal(10), uniform(-2, 5));
            for (int axis = 0; axis < 3; ++axis) {
                const dReal low = uniform(-reach, reach), edge = uniform(dReal(-0.05), 1) * reach;
                box.v[2 * axis] = odd(low);
                box.v[2 * axis + 1] = odd(low + edge);
            }
        }
        if (!boxes[0].overlaps(boxes[1])) continue;
        ++overlapping;
        ASSERT_TRUE(share(grid.cellsOf(boxes[0]), grid.cellsOf(boxes[1]))) << "round " << round;
    }
    EXPECT_GT(overlapping, 2000);
}

}  // namespace
