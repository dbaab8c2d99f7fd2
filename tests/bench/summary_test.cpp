#include "summary.h"

#include <gtest/gtest.h>

using namespace bench;

namespace {

// Batches of ten frames of 0.1 s: one simulated second each.
EngineResult ran(const std::vector<double> &secondsOfBatches) {
    EngineResult engine;
    engine.ready.stepSize = 0.1;
    for (double seconds : secondsOfBatches) {
        Batch batch;
        batch.frames = 10;
        batch.seconds.step = seconds;
        engine.batches.push_back(batch);
    }
    return engine;
}

using Samples = std::vector<double>;

}  // namespace

TEST(RealTimeSamples, AreTakenWhenASecondIsFull) {
    EXPECT_EQ(realTimeSamples(ran({0.5, 0.5, 0.25, 0.25, 0.25, 0.25})), (Samples{2, 4}));
}

TEST(RealTimeSamples, ABatchIsNotCut) {
    EXPECT_EQ(realTimeSamples(ran({0.75, 0.75, 4})), (Samples{2 / 1.5, 0.25}));
}

TEST(RealTimeSamples, TheRestIsLeftOut) {
    EXPECT_EQ(realTimeSamples(ran({1, 0.9})), (Samples{1}));
    EXPECT_EQ(realTimeSamples(ran({0.9})), (Samples{}));
    EXPECT_EQ(realTimeSamples(ran({})), (Samples{}));
}

TEST(RealTimeSamples, OfAnotherPeriod) { EXPECT_EQ(realTimeSamples(ran({0.5, 0.5}), 0.5), (Samples{2, 2})); }
