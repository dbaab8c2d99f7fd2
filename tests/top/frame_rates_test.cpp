// Averages of what two readings differ by.
#include "top/frame_rates.h"

#include <gtest/gtest.h>

#include "world_frames.h"

namespace {

using top::FrameRates;

TEST(FrameRates, AreOfTheFramesBetweenTheReadings) {
    const auto rates = top::ratesBetween({worldFrames(0, 100, 1, 40)}, {worldFrames(0, 100, 1, 140)}, 2);
    ASSERT_EQ(rates.size(), 1u);
    EXPECT_EQ(rates[0].frames, 100u);
    EXPECT_DOUBLE_EQ(rates[0].perSecond, 50);
    EXPECT_NEAR(rates[0].frame, 0.010, 1e-12);
    EXPECT_NEAR(rates[0].collision, 0.002, 1e-12);
    EXPECT_NEAR(rates[0].step, 0.005, 1e-12);
    EXPECT_NEAR(rates[0].parallelCollisions, 0.5, 1e-12);
    EXPECT_NEAR(rates[0].parallelSteps, 0.25, 1e-12);
}

TEST(FrameRates, OfANewWorldInAnOldSlotBeginAnew) {
    const auto rates = top::ratesBetween({worldFrames(0, 100, 1, 40)}, {worldFrames(0, 100, 2, 10)}, 1);
    ASSERT_EQ(rates.size(), 1u);
    EXPECT_EQ(rates[0].frames, 10u);
    EXPECT_NEAR(rates[0].frame, 0.010, 1e-12) << "the first frame has no time";
}

TEST(FrameRates, OfAStillWorldAreZeroAndOfOneThatHasEndedNone) {
    top::WorldFrames ended = worldFrames(1, 100, 2, 40);
    ended.hasEnded = true;
    const auto rates = top::ratesBetween({worldFrames(0, 100, 1, 40), ended}, {worldFrames(0, 100, 1, 40), ended}, 1);
    ASSERT_EQ(rates.size(), 1u);
    EXPECT_EQ(rates[0].world.statistics.number, 1u);
    EXPECT_EQ(rates[0].perSecond, 0);
    EXPECT_EQ(rates[0].frame, 0);
}

TEST(FrameRates, AreInTheOrderOfProcessesAndWorlds) {
    const auto rates = top::ratesOfAll({worldFrames(0, 200, 1, 5), worldFrames(1, 100, 2, 5), worldFrames(2, 100, 1, 1)});
    ASSERT_EQ(rates.size(), 3u);
    EXPECT_EQ(rates[0].world.slot, 2u);
    EXPECT_EQ(rates[1].world.slot, 1u);
    EXPECT_EQ(rates[2].world.slot, 0u);
    EXPECT_NEAR(rates[1].perSecond, 100, 1e-9);
    EXPECT_EQ(rates[0].perSecond, 0) << "one frame has no time";
}

}  // namespace
