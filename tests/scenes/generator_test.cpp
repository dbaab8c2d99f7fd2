#include "scenes/generator.h"

#include <gtest/gtest.h>

#include <algorithm>

using scenes::Generator;

// The first outputs for the seed 1234567 that the authors' own program prints.
TEST(Generator, IsSplitMix64) {
    Generator random(1234567);
    for (std::uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                   4593380528125082431u, 16408922859458223821u})
        EXPECT_EQ(random.next(), expected);
}

TEST(Generator, NumbersSpreadOverTheRangeAndStayInIt) {
    Generator random(1);
    double smallest = 10, largest = -10, sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double value = random.between(-2, 3);
        ASSERT_GE(value, -2);
        ASSERT_LT(value, 3);
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
        sum += value;
    }
    EXPECT_LT(smallest, -1.99);
    EXPECT_GT(largest, 2.99);
    EXPECT_NEAR(sum / 10000, 0.5, 0.1);
}
