// The part of the work that is one thread's, and what it says of more threads.
#include "serial_share.h"

#include <gtest/gtest.h>

namespace {

TEST(SerialShare, IsThePartOfAllWork) {
    bench::SerialWork work;
    EXPECT_FALSE(work.isKnown());
    EXPECT_EQ(work.share(), 1);
    work += {1, 0};
    EXPECT_EQ(work.share(), 1);
    work += {1, 6};
    EXPECT_TRUE(work.isKnown());
    EXPECT_DOUBLE_EQ(work.share(), 0.25);
}

TEST(SerialShare, BoundsTheGain) {
    EXPECT_DOUBLE_EQ(bench::mostGain(1, 16), 1);
    EXPECT_DOUBLE_EQ(bench::mostGain(0, 16), 16);
    EXPECT_DOUBLE_EQ(bench::mostGain(0.25, 1), 1);
    EXPECT_DOUBLE_EQ(bench::mostGain(0.25, 3), 2);
    EXPECT_EQ(bench::gainText(0.25), "25 % of the work is one thread's: with 4, 8, 16 cores at most 2.3, 2.9, 3.4 times as fast as with one");
}

}  // namespace
