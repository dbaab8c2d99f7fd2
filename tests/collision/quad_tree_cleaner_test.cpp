// What dxQuadTreeCleaner keeps: the queue of dirty members, each once in the order of insertion (dxDirtyQueue), and ranks by block and by time
// (dxBlockRanks).
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "collision/spaces/quad_tree/dxQuadTreeCleaner.h"

namespace {

using Slot = dxDirtyQueue::Slot;

// Never looked into.
dxGeom *geom(std::uintptr_t number) { return reinterpret_cast<dxGeom *>(number * 64); }

TEST(DirtyQueue, KeepsTheFirstTurnOfEach) {
    dxDirtyQueue queue;
    for (const Slot slot : {4u, 2u, 4u, 9u, 2u}) queue.push(geom(slot), slot);
    EXPECT_EQ(queue.geoms(), (std::vector<dxGeom *>{geom(4), geom(2), geom(9)}));
    queue.clear();
    EXPECT_TRUE(queue.geoms().empty());
    queue.push(geom(2), 2);
    EXPECT_EQ(queue.geoms(), std::vector<dxGeom *>{geom(2)});
}

TEST(DirtyQueue, ASlotThatIsGivenAgainStandsAtItsNewPlace) {
    dxDirtyQueue queue;
    queue.push(geom(1), 1);
    queue.push(geom(5), 5);
    queue.drop(1);
    queue.drop(1);
    queue.drop(30);
    queue.push(geom(7), 1);
    EXPECT_EQ(queue.geoms(), (std::vector<dxGeom *>{geom(5), geom(7)}));
    queue.drop(5);
    queue.clear();
    queue.push(geom(7), 1);
    EXPECT_EQ(queue.geoms(), std::vector<dxGeom *>{geom(7)});
}

TEST(DirtyQueue, IsWhatAListWouldBe) {
    dxDirtyQueue queue;
    std::vector<Slot> list;
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        const Slot slot = random() % 40;
        const auto at = std::find(list.begin(), list.end(), slot);
        switch (random() % 8) {
        case 0:
            if (random() % 20 != 0) break;
            queue.clear();
            list.clear();
            break;
        case 1: case 2: case 3:
            queue.drop(slot);
            if (at != list.end()) list.erase(at);
            break;
        default:
            queue.push(geom(slot + 1), slot);
            if (at == list.end()) list.push_back(slot);
        }
        if (random() % 3 != 0) continue;
        std::vector<dxGeom *> expected;
        for (const Slot each : list) expected.push_back(geom(each + 1));
        ASSERT_EQ(queue.geoms(), expected);
    }
}

TEST(BlockRanks, FallWithTheBlockAndRiseWithTime) {
    dxBlockRanks ranks(21);
    const dxRank early = ranks.next(7), other = ranks.next(3), late = ranks.next(7), last = ranks.next(20);
    EXPECT_GT(other, late);
    EXPECT_GT(late, early);
    EXPECT_GT(early, last);
    EXPECT_GT(last, 0u);  // 0 is the rank of no member
    for (const dxRank rank : {early, late}) EXPECT_EQ(ranks.blockOf(rank), 7u);
    EXPECT_EQ(ranks.blockOf(other), 3u);
    EXPECT_EQ(ranks.blockOf(last), 20u);
}

TEST(BlockRanks, BlocksAreToldApartByALowestRank) {
    dxBlockRanks ranks(21);
    for (int round = 0; round < 3; ++round)
        for (dxBlockRanks::Block block = 0; block < 21; ++block) {
            const dxRank rank = ranks.next(block);
            for (dxBlockRanks::Block end = 1; end <= 21; ++end) EXPECT_EQ(rank >= ranks.lowestBefore(end), block < end);
        }
}

TEST(BlockRanks, ATreeOfOneBlockHasThemToo) {
    dxBlockRanks ranks(1);
    const dxRank early = ranks.next(0), late = ranks.next(0);
    EXPECT_GT(late, early);
    EXPECT_EQ(ranks.blockOf(late), 0u);
}

TEST(BlockRanks, EndAndBeginAnew) {
    dxBlockRanks ranks(5, 7);  // three bits for the block
    for (int i = 1; i < 16; ++i) {
        EXPECT_FALSE(ranks.isExhausted());
        EXPECT_EQ(ranks.blockOf(ranks.next(4)), 4u);
    }
    EXPECT_TRUE(ranks.isExhausted());
    ranks.startAgain();
    EXPECT_FALSE(ranks.isExhausted());
    EXPECT_EQ(ranks.blockOf(ranks.next(0)), 0u);
}

}  // namespace
