#include "batch_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bench;

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
