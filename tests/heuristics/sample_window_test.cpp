// Average and speed over a window, from no samples at all to more than it holds.
#include "heuristics/dxSampleWindow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(SampleWindow, EverythingIsZeroBeforeThereAreSamples) {
    dxSampleWindow window(4);
    EXPECT_EQ(window.size(), 0u);
    EXPECT_EQ(window.average(), 0);
    EXPECT_EQ(window.speed(), 0);
}

TEST(SampleWindow, OneSampleHasAnAverageAndNoSpeed) {
    dxSampleWindow window(4);
    window.add(7);
    EXPECT_EQ(window.average(), 7);
    EXPECT_EQ(window.speed(), 0);
}

// Against the definition, computed from all samples.
TEST(SampleWindow, CoversExactlyTheLastSamples) {
    for (const unsigned size : {1u, 2u, 3u, 10u}) {
        dxSampleWindow window(size);
        std::vector<double> all;
        for (int i = 0; i < 50; ++i) {
            all.push_back(i * i % 17);
            window.add(all.back());
            const std::size_t n = std::min<std::size_t>(all.size(), size);
            double sum = 0;
            for (std::size_t k = all.size() - n; k < all.size(); ++k) sum += all[k];
            EXPECT_DOUBLE_EQ(window.average(), sum / n);
            EXPECT_DOUBLE_EQ(window.speed(), n < 2 ? 0 : (all.back() - all[all.size() - n]) / (n - 1.0));
            EXPECT_EQ(window.size(), n);
        }
    }
}

TEST(SampleWindow, SpeedIsPerFrame) {
    dxSampleWindow window(10);
    for (int i = 0; i < 30; ++i) window.add(5 - 3.0 * i);
    EXPECT_DOUBLE_EQ(window.speed(), -3);
}

TEST(SampleWindow, AWindowOfNothingIsOneFrame) {
    dxSampleWindow window(0);
    window.add(1);
    window.add(2);
    EXPECT_EQ(window.window(), 1u);
    EXPECT_EQ(window.average(), 2);
    EXPECT_EQ(window.speed(), 0);
}

TEST(SampleWindow, NaNAndInfinityCountOnlyWhileTheyAreInTheWindow) {
    for (const double odd : {kNaN, kInfinity, -kInfinity}) {
        dxSampleWindow window(3);
        window.add(odd);
        EXPECT_FALSE(std::isfinite(window.average()));
        window.add(1);
        EXPECT_FALSE(std::isfinite(window.speed()));
        window.add(2);
        window.add(3);
        EXPECT_DOUBLE_EQ(window.average(), 2);
        EXPECT_DOUBLE_EQ(window.speed(), 1);
    }
}

TEST(SampleWindow, ClearForgets) {
    dxSampleWindow window(2);
    for (int i = 0; i < 5; ++i) window.add(100);
    window.clear();
    EXPECT_EQ(window.size(), 0u);
    EXPECT_EQ(window.average(), 0);
    window.add(1);
    window.add(3);
    window.add(5);
    EXPECT_EQ(window.average(), 4);
    EXPECT_EQ(window.speed(), 2);
}

// A huge window costs memory only for samples that exist.
TEST(SampleWindow, TheLargestWindowIsFine) {
    dxSampleWindow window(std::numeric_limits<unsigned>::max());
    window.add(1);
    window.add(2);
    EXPECT_DOUBLE_EQ(window.average(), 1.5);
}

}  // namespace
