#include "stopping_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

using Verdict = StoppingRule::Verdict;

namespace {

RunningAverage steady() {
    RunningAverage average;
    for (int i = 0; i < 20; ++i) average.add(100, 1);
    return average;
}

RunningAverage rising() {
    RunningAverage average;
    for (int i = 0; i < 20; ++i) average.add(100, 1 + i);
    return average;
}

StoppingRule rule() {
    StoppingRule rule;
    rule.tolerance = 0.02;
    rule.minimumRounds = 10;
    rule.maximumSeconds = 5;
    rule.maximumFrames = 1000;
    return rule;
}

}  // namespace

TEST(StoppingRule, StopsWhenAllAveragesAreStable) {
    EXPECT_EQ(rule().judge({steady(), steady()}, 10, 1, 500), Verdict::Stable);
}

TEST(StoppingRule, GoesOnWhileOneAverageStillMoves) {
    EXPECT_EQ(rule().judge({steady(), rising()}, 10, 1, 500), Verdict::GoOn);
}

TEST(StoppingRule, GoesOnUntilTheQuartilesMeanSomething) {
    EXPECT_EQ(rule().judge({steady()}, 9, 1, 500), Verdict::GoOn);
}

TEST(StoppingRule, GoesOnUntilItsLeastTime) {
    StoppingRule patient = rule();
    patient.minimumSeconds = 2;
    EXPECT_EQ(patient.judge({steady()}, 10, 1.9, 500), Verdict::GoOn);
    EXPECT_EQ(patient.judge({steady()}, 10, 2, 500), Verdict::Stable);
}

TEST(StoppingRule, StopsAtTheLimits) {
    EXPECT_EQ(rule().judge({rising()}, 10, 5, 500), Verdict::OutOfTime);
    EXPECT_EQ(rule().judge({rising()}, 10, 1, 1000), Verdict::OutOfFrames);
}

TEST(StoppingRule, SaysWhy) {
    EXPECT_EQ(toString(Verdict::Stable), "averages stable");
    EXPECT_NE(toString(Verdict::OutOfTime).find("time limit"), std::string::npos);
    EXPECT_NE(toString(Verdict::OutOfFrames).find("frame limit"), std::string::npos);
}

TEST(BatchSize, TinyWorldsRunManyFramesAtATime) {
    EXPECT_EQ(batchSize(16e-6, 16e-6), 5000);
    EXPECT_GE(batchSize(16e-6, 16e-6) * 16e-6, 0.010);
}

TEST(BatchSize, EveryBatchOfAWorldBelowTenMillisecondsTakesFiftyOrMore) {
    for (double seconds = 5e-6; seconds < 10e-3; seconds *= 1.1) {
        EXPECT_GE(batchSize(seconds, seconds) * seconds, 0.050) << seconds;
        EXPECT_LE(batchSize(seconds, seconds) * seconds, 0.130) << seconds;
    }
}

TEST(BatchSize, HeavyWorldsRunAFewFrames) {
    EXPECT_EQ(batchSize(0.025, 0.025), 5);
    EXPECT_EQ(batchSize(0.39, 0.39), 5);
}

TEST(BatchSize, VeryHeavyWorldsRunFewer) {
    EXPECT_EQ(batchSize(0.5, 0.5), 2);
    EXPECT_EQ(batchSize(2.5, 2.5), 1);
    EXPECT_EQ(batchSize(1e6, 1e6), 1);
}

TEST(BatchSize, TheFastestHasLongTurnsAndTheSlowestNoEndlessOnes) {
    EXPECT_EQ(batchSize(50e-6, 100e-6), 1000);
    EXPECT_EQ(batchSize(50e-6, 1e-3), 1000);
    EXPECT_EQ(batchSize(50e-6, 3e-3), 500);
    EXPECT_EQ(batchSize(50e-6, 0.3), 5);
    EXPECT_EQ(batchSize(50e-6, 3), 1);
}

TEST(BatchSize, BatchesEndAtMultiplesOfHundredFrames) {
    for (double seconds = 1e-7; seconds < 1; seconds *= 1.3) {
        const int frames = batchSize(seconds, seconds);
        EXPECT_TRUE(100 % frames == 0 || frames % 100 == 0) << frames;
    }
}

TEST(BatchSize, ATimeThatIsNoTimeGivesTheLargest) {
    EXPECT_EQ(batchSize(0, 0), 10'000);
    EXPECT_EQ(batchSize(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()),
              10'000);
}
