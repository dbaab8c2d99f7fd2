// dxMotionBound: how far members may move, and for how many frames a gap lasts. dxCheckFrequencyHeuristic misses no meeting: members move at
// random, and every frame that is not checked is examined by brute force.
#include "clusters/heuristics/dxCheckFrequencyHeuristic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "SwarmCallers.h"

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

const SwarmSetting kSettings[] = {
    {0.1, 0.05, 0.01, 8},  // slow and few
    {2, 9.81, 0.01, 8},    // falling
    {5, 50, 0.008, 12},    // jerking
    {20, 0, 0.016, 20},    // fast and crowded, constant velocities
    {0, 20, 0.02, 16},     // from rest
    {300, 1e4, 0.03, 6},   // several members' sizes in a frame
};

template <class Real>
void expectNothingMissed() {
    unsigned meetings = 0, checks = 0, frames = 0;
    for (const SwarmSetting &setting : kSettings) {
        for (unsigned seed = 0; seed < 6; ++seed) {
            for (const auto caller : {askEveryFrame<Real, false>, askEveryFrame<Real, true>, trust<Real>}) {
                const Outcome outcome = caller(Swarm<Real>(setting, seed));
                EXPECT_EQ(outcome.missed, 0u) << setting.speed << " m/s, seed " << seed;
                EXPECT_EQ(outcome.overstated, 0u) << setting.speed << " m/s, seed " << seed;
                meetings += outcome.meetings;
                checks += outcome.checks;
                frames += kFrames;
            }
        }
    }
    EXPECT_GT(meetings, 500u) << "or nothing was tried";
    EXPECT_LT(checks, frames / 2) << "or nothing was saved";
}

TEST(CheckFrequencyHeuristic, NoMeetingIsMissedInDoublePrecision) { expectNothingMissed<double>(); }
TEST(CheckFrequencyHeuristic, NoMeetingIsMissedInSinglePrecision) { expectNothingMissed<float>(); }

TEST(CheckFrequencyHeuristic, SlowWorldsAreHardlyChecked) {
    const Outcome outcome = askEveryFrame<double, false>(Swarm<double>(kSettings[0], 3));
    EXPECT_LT(outcome.checks, kFrames / 20);
}

// The worst case: both members accelerate straight at each other as hard as they may.
TEST(CheckFrequencyHeuristic, AHeadOnMeetingIsSeenInItsFrameAndNotLongBefore) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    const double acceleration = 10, step = 0.01;
    double gap = 4, speed = 0;
    unsigned checks = 0;
    for (unsigned frame = 0; gap > 0; ++frame) {
        const dxMotionBound motion{speed, acceleration, step, 0};
        if (heuristic.framesToSkip(motion) == 0) {
            ++checks;
            heuristic.checked(gap);
        }
        speed += acceleration * step;
        gap -= 2 * speed * step;
        heuristic.moved(motion);
    }
    EXPECT_EQ(heuristic.framesToSkip({speed, acceleration, step, 0}), 0u);
    EXPECT_EQ(checks, 1u) << "the bound is exact here: one check at the start, the next when they meet";
}

TEST(CheckFrequencyHeuristic, ProvesNothingBeforeTheFirstCheckOrWhileItDoesNotRun) {
    const dxMotionBound slow{0.01, 0, 0.01, 0};
    dxCheckFrequencyHeuristic heuristic;
    heuristic.checked(1);
    EXPECT_EQ(heuristic.framesToSkip(slow), 0u) << "not started";
    heuristic.start();
    EXPECT_GT(heuristic.framesToSkip(slow), 100u);
    heuristic.pause();
    EXPECT_EQ(heuristic.framesToSkip(slow), 0u);
    heuristic.stop();
    EXPECT_EQ(heuristic.framesToSkip(slow), 0u);
    heuristic.reset();
    heuristic.start();
    EXPECT_EQ(heuristic.framesToSkip(slow), 0u) << "nothing was checked since";
}

TEST(CheckFrequencyHeuristic, WhatMovesDuringAPauseCounts) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    heuristic.checked(1);
    heuristic.pause();
    heuristic.moved({1, 0, 0.1, 0}, 6);
    heuristic.start();
    EXPECT_EQ(heuristic.gap(), 0);
    EXPECT_EQ(heuristic.framesToSkip({0, 0, 0.1, 0}), 0u);
}

TEST(CheckFrequencyHeuristic, InvalidateAsksForACheck) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    heuristic.checked(100);
    heuristic.invalidate();
    EXPECT_EQ(heuristic.framesToSkip({0, 0, 0.01, 0}), 0u);
}

TEST(CheckFrequencyHeuristic, OddMotionAsksForACheckNowAndLater) {
    const dxMotionBound slow{0.01, 0, 0.01, 0};
    for (const double odd : {Limits::quiet_NaN(), Limits::infinity(), -1.0}) {
        dxCheckFrequencyHeuristic heuristic;
        heuristic.start();
        heuristic.checked(Limits::infinity());
        EXPECT_EQ(heuristic.framesToSkip({odd, 0, 0.01, 0}), 0u) << odd;
        EXPECT_GT(heuristic.framesToSkip(slow), 0u) << "asking alone changes nothing";
        heuristic.moved({odd, 0, 0.01, 0});
        EXPECT_EQ(heuristic.framesToSkip(slow), 0u) << odd;
    }
}

TEST(CheckFrequencyHeuristic, OddGapsAskForACheck) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    for (const double gap : {Limits::quiet_NaN(), 0.0, -1.0, -Limits::infinity()}) {
        heuristic.checked(gap);
        EXPECT_EQ(heuristic.framesToSkip({0, 0, 0.01, 0}), 0u) << gap;
    }
    heuristic.checked(Limits::infinity());
    EXPECT_EQ(heuristic.framesToSkip({1, 1, 0.01, 0}), dxCheckFrequencyHeuristic::kMaxFrames);
}

// A subtraction that rounds to nothing must not keep a gap constant.
TEST(CheckFrequencyHeuristic, MotionTooSmallToBeSeenInTheGapStillCounts) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    heuristic.checked(1);
    double before = heuristic.gap();
    for (int i = 0; i < 100; ++i) {
        heuristic.moved({1e-18, 0, 0.01, 0});
        EXPECT_LT(heuristic.gap(), before);
        before = heuristic.gap();
    }
    heuristic.moved({1, 1, 1, 0}, 0);
    EXPECT_EQ(heuristic.gap(), before) << "no frame, no motion";
}

}  // namespace
