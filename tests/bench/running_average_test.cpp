#include "running_average.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bench;

TEST(RunningAverage, KeepsOneValueEveryHundredFrames) {
    RunningAverage average;
    for (int i = 0; i < 25; ++i) average.add(10, 1.0);
    EXPECT_EQ(average.kept(), (std::vector<double>{0.1, 0.1}));
}

TEST(RunningAverage, KeptValuesAverageOverAllFramesSoFar) {
    RunningAverage average;
    average.add(100, 100);  // 1 s a frame
    average.add(100, 300);  // 3 s a frame
    EXPECT_EQ(average.kept(), (std::vector<double>{1, 2}));
}

TEST(RunningAverage, ALongBatchGivesOneValue) {
    RunningAverage average;
    average.add(1000, 10);
    EXPECT_EQ(average.kept().size(), 1u);
}

TEST(RunningAverage, SummaryIsOfTheKeptValues) {
    RunningAverage average;
    average.add(100, 100);
    average.add(100, 300);
    average.add(50, 5000);  // not at a multiple of 100
    EXPECT_DOUBLE_EQ(average.summary().mean, 1.5);
    EXPECT_NEAR(average.summary().deviation, std::sqrt(0.5), 1e-12);
}

TEST(RunningAverage, SummaryBeforeTheFirstKeptValueIsTheAverageSoFar) {
    RunningAverage average;
    EXPECT_TRUE(std::isnan(average.summary().mean));
    average.add(4, 2);
    EXPECT_DOUBLE_EQ(average.summary().mean, 0.5);
}

TEST(RunningAverage, SpreadIsInfiniteUntilTenValuesAreKept) {
    RunningAverage average;
    for (int i = 0; i < 9; ++i) average.add(100, 1);
    EXPECT_TRUE(std::isinf(average.relativeSpread()));
    average.add(100, 1);
    EXPECT_NEAR(average.relativeSpread(), 0, 1e-12);
}

TEST(RunningAverage, SpreadForgetsHowItBegan) {
    RunningAverage average;
    average.add(100, 50);
    for (int i = 0; i < 9; ++i) average.add(100, 1);
    const double early = average.relativeSpread();
    for (int i = 0; i < 500; ++i) average.add(100, 1);
    EXPECT_GT(early, 1);
    EXPECT_LT(average.relativeSpread(), 0.02);
}
