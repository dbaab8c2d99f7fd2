// The cell in which upstream's hash space finds a pair, beside a search through all cells of both boxes.
#include "collision/spaces/hash/dxHashCells.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace {

using Cell = dxHashCells::Cell;
using Box = std::array<dReal, 6>;

constexpr dxHashLevels kLevels = {-3, 10};

// Requires that the first box is not on a higher level than the second.
std::optional<Cell> firstShared(const dxHashCells &searcher, const dxHashCells &found) {
    std::vector<Cell> cells;
    found.forEachCell(found.level(), [&cells](const Cell &cell) { cells.push_back(cell); });
    std::optional<Cell> first;
    searcher.forEachCell(found.level(), [&](const Cell &cell) {
        for (const Cell &other : cells)
            if (!first && other == cell) first = cell;
    });
    return first;
}

void expectFirstShared(const Box &a, const Box &b) {
    dxHashCells searcher(a.data(), kLevels), found(b.data(), kLevels);
    if (searcher.level() > found.level()) std::swap(searcher, found);
    ASSERT_EQ(searcher.kind(), dxHashCells::Kind::inTable);
    ASSERT_EQ(found.kind(), dxHashCells::Kind::inTable);
    const std::optional<Cell> expected = firstShared(searcher, found);
    Cell cell{};
    ASSERT_EQ(dxHashCells::firstSharedCell(searcher, found, cell), expected.has_value());
    if (!expected) return;
    EXPECT_EQ(cell.x, expected->x);
    EXPECT_EQ(cell.y, expected->y);
    EXPECT_EQ(cell.z, expected->z);
}

// One box begins below zero and the other above: they have different slots in the first column and the same in the second.
TEST(HashCells, TheFirstColumnMayHaveOtherSlots) {
    const Box below = {0.7, 1.3, 0.1, 0.5, -0.3, 0.3}, above = {0.7, 1.3, 0.1, 0.5, 0.1, 0.6};
    dxHashCells::Cell cell{};
    ASSERT_TRUE(dxHashCells::firstSharedCell({below.data(), kLevels}, {above.data(), kLevels}, cell));
    EXPECT_EQ(cell.x, 1);
    EXPECT_EQ(cell.y, 0);
    EXPECT_EQ(cell.z, 0);
    expectFirstShared(below, above);
}

// Cells are numbered by ints, the least and the largest of which are not used to the full.
TEST(HashCells, NumbersUpToTheLargestInt) {
    const auto kindAt = [](dReal x) {
        const Box box = {x - 0.9, x, 0, 0.9, 0, 0.9};  // in cells of 1
        return dxHashCells(box.data(), {0, 10}).kind();
    };
    constexpr dReal kLargest = 2147483647;
    EXPECT_EQ(kindAt(kLargest - 1), dxHashCells::Kind::inTable);
    EXPECT_EQ(kindAt(kLargest), dxHashCells::Kind::outOfRange);
    EXPECT_EQ(kindAt(-kLargest + 1), dxHashCells::Kind::inTable);
    EXPECT_EQ(kindAt(-kLargest - 1), dxHashCells::Kind::outOfRange);
}

TEST(HashCells, TheFirstSharedCellIsThatOfASearchThroughAll) {
    std::mt19937 random(1);
    std::uniform_real_distribution<dReal> place(-1.5, 1.5), size(0.05, 1.5);
    const auto draw = [&] {
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            box[2 * axis] = place(random);
            box[2 * axis + 1] = box[2 * axis] + size(random);
        }
        return box;
    };
    for (int i = 0; i < 20000 && !testing::Test::HasFailure(); ++i) expectFirstShared(draw(), draw());
}

}  // namespace
