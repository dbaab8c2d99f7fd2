#include "frame_times.h"

#include <gtest/gtest.h>

using bench::FrameTimes;

TEST(FrameTimes, AreCountedInTheBinThatTheyLieIn) {
    FrameTimes times;
    for (const double seconds : {1e-6, 1e-6, 0.25}) times.add(seconds);
    ASSERT_EQ(times.counts().size(), 2u);
    for (const auto &[bin, frames] : times.counts()) {
        const double seconds = frames == 2 ? 1e-6 : 0.25;
        EXPECT_LE(FrameTimes::lowerBound(bin), seconds * (1 + 1e-12));
        EXPECT_GT(FrameTimes::lowerBound(bin + 1), seconds * (1 - 1e-12));
    }
}

TEST(FrameTimes, ABinsWidthIsAPartOfADoubling) {
    EXPECT_DOUBLE_EQ(FrameTimes::lowerBound(3 + FrameTimes::kBinsPerDoubling), 2 * FrameTimes::lowerBound(3));
}

TEST(FrameTimes, WhatTheClockDidNotResolveIsInTheFirstBin) {
    FrameTimes times;
    times.add(0);
    times.add(-1e-9);
    EXPECT_EQ(times.counts(), (std::map<int, long>{{0, 2}}));
}

TEST(FrameTimes, SumsHoldTheFramesOfBoth) {
    FrameTimes one, other;
    one.add(3, 5);
    other.add(3, 2);
    other.add(4, 1);
    one += other;
    EXPECT_EQ(one.counts(), (std::map<int, long>{{3, 7}, {4, 1}}));
}
