// The parts that decisions about sharing have in common (dxParallelPayoff.h).
#include "threading/payoff/dxParallelPayoff.h"

#include <gtest/gtest.h>

namespace {

TEST(ParallelPayoff, AMovingAverageComesTowardsTheNewest) {
    EXPECT_DOUBLE_EQ(dxMovingAverage(100, 200, 0.25), 125);
    EXPECT_EQ(dxMovingAverage(100, 200, 0), 100);
    EXPECT_EQ(dxMovingAverage(100, 200, 1), 200);
    double mean = 0;
    for (int i = 0; i < 200; ++i) mean = dxMovingAverage(mean, 50, 1.0 / 16);
    EXPECT_NEAR(mean, 50, 1e-3);
}

TEST(ParallelPayoff, WhatPaysClearlyIsBetterByTheMargin) {
    EXPECT_TRUE(dxPaysClearly(89, 100, 0.9));
    EXPECT_FALSE(dxPaysClearly(90, 100, 0.9));
    EXPECT_FALSE(dxPaysClearly(0, 0, 0.9));
}

TEST(ParallelPayoff, RetryIntervalsDoubleAndShortenWithinTheirLimits) {
    constexpr dxRetryLimits<int> kCalls{48, 768};
    EXPECT_EQ(kCalls.afterFailure(0), 48);
    EXPECT_EQ(kCalls.afterFailure(48), 96);
    EXPECT_EQ(kCalls.afterFailure(768), 768);
    constexpr dxRetryLimits<double> kParts{1.0 / 32, 1};
    EXPECT_EQ(kParts.afterFailure(1), 1);
    EXPECT_EQ(kParts.afterFailure(0.25), 0.5);
    EXPECT_EQ(kParts.afterSuccess(1, 0.5), 0.5);
    EXPECT_EQ(kParts.afterSuccess(1.0 / 32, 0.5), 1.0 / 32);
}

}  // namespace
