#include "stopping_rule.h"

#include <gtest/gtest.h>

using namespace bench;
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
