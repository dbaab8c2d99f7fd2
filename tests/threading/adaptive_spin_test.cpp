// How long a worker spins: dxAdaptiveSpin.
#include "threading/pool/dxParking.h"

#include <gtest/gtest.h>

namespace {

using std::chrono::microseconds;

TEST(AdaptiveSpin, IsShortWithoutExperience) { EXPECT_EQ(dxAdaptiveSpin().spinTime(), kSpinTime); }

TEST(AdaptiveSpin, CoversTheLongestOfRecentWaits) {
    dxAdaptiveSpin spin;
    for (int frame = 0; frame < 100; ++frame) {
        spin.remember(microseconds(5));  // between two stages of a frame
        spin.remember(microseconds(400));
    }
    EXPECT_GT(spin.spinTime(), microseconds(400));
    EXPECT_LT(spin.spinTime(), microseconds(600));
}

TEST(AdaptiveSpin, DoesNotSpinThroughLongWaits) {
    dxAdaptiveSpin spin;
    for (int frame = 0; frame < 100; ++frame) spin.remember(std::chrono::milliseconds(20));
    EXPECT_EQ(spin.spinTime(), kSpinTime);
}

TEST(AdaptiveSpin, NeverSpinsLongerThanItsBound) {
    dxAdaptiveSpin spin;
    spin.remember(dxAdaptiveSpin::kMaxSpin);
    EXPECT_EQ(spin.spinTime(), dxAdaptiveSpin::kMaxSpin);
}

TEST(AdaptiveSpin, FadesWhenWaitsGetShort) {
    dxAdaptiveSpin spin;
    spin.remember(microseconds(900));
    for (int frame = 0; frame < 100; ++frame) spin.remember(microseconds(5));
    EXPECT_EQ(spin.spinTime(), kSpinTime);
}

}  // namespace
