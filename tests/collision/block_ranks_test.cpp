// dxBlockRanks: ranks by block and by time.
#include <gtest/gtest.h>

#include "collision/spaces/dxBlockRanks.h"

namespace {

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
