#include "clusters/heuristics/dxHeuristic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace {

double medianOf(std::vector<double> numbers) { return dxMedian(numbers); }

TEST(Median, IsTheMiddleOneTheLowerOfTwo) {
    EXPECT_EQ(medianOf({}), 0);
    EXPECT_EQ(medianOf({4}), 4);
    EXPECT_EQ(medianOf({9, 1}), 1);
    EXPECT_EQ(medianOf({9, 1, 5}), 5);
    EXPECT_EQ(medianOf({4, 3, 2, 1}), 2);
    EXPECT_EQ(medianOf({1, std::numeric_limits<double>::infinity(), 2}), 2);
}

TEST(Median, AgreesWithSorting) {
    std::mt19937 random(1);
    for (std::size_t n = 1; n < 60; ++n) {
        std::vector<double> numbers(n);
        for (double &number : numbers) number = random() % 20;
        std::vector<double> sorted = numbers;
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(dxMedian(numbers), sorted[(n - 1) / 2]);
        EXPECT_TRUE(std::is_permutation(numbers.begin(), numbers.end(), sorted.begin()));
    }
}

}  // namespace
