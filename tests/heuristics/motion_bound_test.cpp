// How far members may travel, and for how many frames a gap lasts.
#include "clusters/heuristics/dxMotionBound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using Limits = std::numeric_limits<double>;

constexpr unsigned kLimit = 1000;

TEST(MotionBound, ReachIsTheDistanceAtConstantAcceleration) {
    const dxMotionBound motion{3, 2, 0.5, 0.25};
    EXPECT_EQ(motion.reach(0), 0);
    double speed = motion.speed, position = 0;
    for (unsigned frames = 1; frames < 100; ++frames) {
        speed += motion.acceleration * motion.step;  // as ODE: the velocity first
        position += speed * motion.step + motion.rounding;
        EXPECT_GE(motion.reach(frames), position);
        EXPECT_NEAR(motion.reach(frames), position, 1e-9 * position);
    }
}

TEST(MotionBound, TwoMembersThatApproachEachComeHalfOfTheWay) {
    const dxMotionBound motion{1, 0, 0.0625, 0};  // the gap shrinks by 1/8 a frame
    EXPECT_EQ(dxFramesApart(motion, 1, kLimit), 8u) << "they touch after 8 steps";
    EXPECT_EQ(dxFramesApart(motion, 1.01, kLimit), 9u);
    EXPECT_EQ(dxFramesApart(motion, 0.99, kLimit), 8u);
    EXPECT_EQ(dxFramesApart(motion, 0.125, kLimit), 1u);
    EXPECT_EQ(dxFramesApart(motion, 0.12, kLimit), 1u) << "apart now, though not after the step";
}

TEST(MotionBound, AgreesWithCountingFrameByFrame) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> decade(-4, 2);
    const auto any = [&] { return random() % 5 == 0 ? 0 : std::pow(10, decade(random)); };
    for (int i = 0; i < 3000; ++i) {
        const dxMotionBound motion{any(), any(), 0.001 + any() / 100, any() * 1e-6};
        const double gap = any();
        unsigned counted = 0;
        while (counted < kLimit && 2 * motion.reach(counted) < gap) ++counted;
        ASSERT_EQ(dxFramesApart(motion, gap, kLimit), counted);
    }
}

TEST(MotionBound, WhatMeetsOrDoesNotProveAnythingIsCheckedAtOnce) {
    const dxMotionBound still{0, 0, 0.01, 0};
    for (const double gap : {0.0, -0.0, -1.0, -Limits::infinity(), Limits::quiet_NaN()}) {
        EXPECT_EQ(dxFramesApart(still, gap, kLimit), 0u) << gap;
    }
    for (const double odd : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), -1.0}) {
        for (int field = 0; field < 4; ++field) {
            double numbers[4] = {1, 1, 0.01, 0};
            numbers[field] = odd;
            const dxMotionBound motion{numbers[0], numbers[1], numbers[2], numbers[3]};
            EXPECT_FALSE(motion.proves());
            EXPECT_EQ(dxFramesApart(motion, 1, kLimit), 0u) << odd;
            EXPECT_EQ(dxFramesApart(motion, Limits::infinity(), kLimit), 0u) << odd;
        }
    }
}

TEST(MotionBound, NumbersThatOverflowProveNothing) {
    EXPECT_EQ(dxFramesApart({1e300, 0, 1e300, 0}, Limits::max(), kLimit), 0u);
    EXPECT_EQ(dxFramesApart({0, 1e300, 1e300, 0}, Limits::max(), kLimit), 0u);
    EXPECT_EQ(dxFramesApart({1e308, 0, 1, 0}, Limits::max(), kLimit), 1u) << "apart now; then who knows";
}

TEST(MotionBound, TheLimitHolds) {
    EXPECT_EQ(dxFramesApart({0, 0, 0.01, 0}, 1, kLimit), kLimit);
    EXPECT_EQ(dxFramesApart({1, 1, 0.01, 0}, Limits::infinity(), kLimit), kLimit);
    EXPECT_EQ(dxFramesApart({1, 0, 0, 0}, Limits::denorm_min(), kLimit), kLimit) << "a step of no time";
    EXPECT_EQ(dxFramesApart({0, 0, 0.01, 0}, 1, 0), 0u);
}

}  // namespace
