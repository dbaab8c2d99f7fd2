#include "number_text.h"

#include <gtest/gtest.h>

#include <limits>

using namespace bench;

TEST(NumberText, HasThreeDigitsButNoMoreThanFourBehindThePoint) {
    EXPECT_EQ(numberText(1234.5), "1234");
    EXPECT_EQ(numberText(12.345), "12.3");
    EXPECT_EQ(numberText(1.2345), "1.23");
    EXPECT_EQ(numberText(0.12345), "0.123");
    EXPECT_EQ(numberText(0.0000123), "0.0000");
    EXPECT_EQ(millisecondsText(0.0123), "12.3");
}

TEST(NumberText, WhatIsNotKnownIsADash) {
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "-");
    EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "-");
}
