// dxHierarchicalGrid against brute force, and that it does not grow with what has passed through.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "RandomBoxes.h"
#include "collision/broadphase/dxHierarchicalGrid.h"

namespace {

using Slot = dxHierarchicalGrid::Slot;

// How often each slot is visited.
std::map<Slot, int> visits(const dxHierarchicalGrid &grid, const dxBounds &box) {
    std::map<Slot, int> counts;
    grid.query(box, [&](Slot slot) { ++counts[slot]; });
    return counts;
}

TEST(HierarchicalGrid, AnEmptyGridFindsNothing) {
    EXPECT_TRUE(visits(dxHierarchicalGrid(), cubeAt(0, 0, 0)).empty());
    EXPECT_TRUE(visits(dxHierarchicalGrid(), boundsOf(-kInfinite, kInfinite, kNaN, 0, 0, 0)).empty());
}

TEST(HierarchicalGrid, FindsAStoredBoxAndForgetsARemovedOne) {
    dxHierarchicalGrid grid;
    grid.insert(3, cubeAt(0, 0, 0));
    EXPECT_EQ(visits(grid, cubeAt(dReal(0.5), 0, 0)), (std::map<Slot, int>{{3, 1}}));
    grid.remove(3);
    EXPECT_TRUE(visits(grid, cubeAt(0, 0, 0)).empty());
}

TEST(HierarchicalGrid, DoesNotVisitWhatIsFarAway) {
    dxHierarchicalGrid grid;
    for (Slot slot = 0; slot < 1000; ++slot) grid.insert(slot, cubeAt(dReal(slot) * 10, 0, 0));
    EXPECT_LE(visits(grid, cubeAt(5000, 0, 0)).size(), 2u);
}

TEST(HierarchicalGrid, FindsEveryOverlapOnceWhateverTheBoxes) {
    RandomBoxes random(1);
    std::size_t overlaps = 0;
    for (int round = 0; round < 40; ++round) {
        dxHierarchicalGrid grid;
        std::map<Slot, dxBounds> stored;
        for (int step = 0; step < 400; ++step) {
            const Slot slot = random.below(120);
            if (stored.count(slot) != 0) {
                grid.remove(slot);
                stored.erase(slot);
            }
            if (!random.oneIn(4)) grid.insert(slot, stored[slot] = random.box());
            const dxBounds query = stored.empty() || random.oneIn(2) ? random.box() : stored.begin()->second;
            const auto counts = visits(grid, query);
            for (const auto &[visited, count] : counts) {
                ASSERT_EQ(count, 1) << "slot " << visited;
                ASSERT_EQ(stored.count(visited), 1u) << "slot " << visited;
            }
            for (const auto &[other, box] : stored) {
                if (!box.overlaps(query)) continue;
                ++overlaps;
                ASSERT_EQ(counts.count(other), 1u) << "round " << round << ", step " << step << ", slot " << other;
            }
        }
    }
    EXPECT_GT(overlaps, 10000u);
}

// Things that travel leave empty cells behind; those are dropped in time.
TEST(HierarchicalGrid, StaysBoundedWhileThingsTravel) {
    constexpr Slot kBoxes = 20;
    constexpr int kMoves = 100000;
    dxHierarchicalGrid grid;
    std::size_t most = 0;
    for (Slot slot = 0; slot < kBoxes; ++slot) grid.insert(slot, cubeAt(0, dReal(slot) * 3, 0));
    for (int move = 0; move < kMoves; ++move) {
        const Slot slot = static_cast<Slot>(move) % kBoxes;
        const dxBounds box = cubeAt(dReal(move) / 4, dReal(slot) * 3, 0);
        grid.remove(slot);
        grid.insert(slot, box);
        most = std::max(most, grid.cellCount());
        if (move % 1000 == 0) {
            ASSERT_EQ(visits(grid, box).count(slot), 1u);
        }
    }
    // At most eight cells a box; the table is less than eight times as large as what is in it.
    EXPECT_LE(most, kBoxes * 8 * 8);
}

TEST(HierarchicalGrid, StaysBoundedWhileSizesChange) {
    RandomBoxes random(2);
    dxHierarchicalGrid grid;
    std::size_t most = 0;
    for (Slot slot = 0; slot < 20; ++slot) grid.insert(slot, random.box());
    for (int move = 0; move < 100000; ++move) {
        const Slot slot = random.below(20);
        grid.remove(slot);
        grid.insert(slot, random.box());
        most = std::max(most, grid.cellCount());
    }
    EXPECT_LE(most, 20u * 8 * 8);
}

}  // namespace
