#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace support;

TEST(Statistics, MedianOfOddCountIsTheMiddleValue) { EXPECT_DOUBLE_EQ(median({5, 1, 9}), 5); }

TEST(Statistics, MedianOfEvenCountIsBetweenTheMiddleTwo) {
    EXPECT_DOUBLE_EQ(median({4, 1, 3, 2}), 2.5);
}

TEST(Statistics, QuantilesReachFromSmallestToLargest) {
    const std::vector<double> values = {30, 10, 20};
    EXPECT_DOUBLE_EQ(quantile(values, 0), 10);
    EXPECT_DOUBLE_EQ(quantile(values, 1), 30);
    EXPECT_DOUBLE_EQ(quantile(values, 0.25), 15);
}

TEST(Statistics, SpreadOfHundredAndOneValues) {
    std::vector<double> values;
    for (int i = 100; i >= 0; --i) values.push_back(i);
    const Spread spread = spreadOf(values);
    EXPECT_DOUBLE_EQ(spread.median, 50);
    EXPECT_DOUBLE_EQ(spread.lowerQuartile, 25);
    EXPECT_DOUBLE_EQ(spread.upperQuartile, 75);
    EXPECT_DOUBLE_EQ(spread.percentile5, 5);
    EXPECT_DOUBLE_EQ(spread.percentile95, 95);
}

TEST(Statistics, OneOutlierDoesNotMoveTheMedian) { EXPECT_DOUBLE_EQ(spreadOf({1, 1, 1, 1, 1000}).median, 1); }

TEST(Statistics, NoValuesGiveNaN) {
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
    EXPECT_TRUE(std::isnan(spreadOf({}).median));
    EXPECT_TRUE(std::isnan(meanAndDeviation({}).mean));
}

TEST(Statistics, DeviationIsThatOfASample) {
    const MeanAndDeviation result = meanAndDeviation({2, 4, 4, 4, 5, 5, 7, 9});
    EXPECT_DOUBLE_EQ(result.mean, 5);
    EXPECT_NEAR(result.deviation, std::sqrt(32.0 / 7), 1e-12);
    EXPECT_DOUBLE_EQ(meanAndDeviation({3}).deviation, 0);
}

TEST(Statistics, RatiosPairValuesOfTheSameRound) {
    EXPECT_EQ(pairedRatios({2, 30, 8}, {1, 10, 16}), (std::vector<double>{2, 3, 0.5}));
}

TEST(Statistics, RatiosEndWithTheShorterSeries) { EXPECT_EQ(pairedRatios({2, 3, 4}, {1}).size(), 1u); }

TEST(Statistics, RatiosLeaveOutTimesThatTheClockDidNotResolve) {
    EXPECT_EQ(pairedRatios({0, 6, 5}, {1, 3, 0}), (std::vector<double>{2}));
}
