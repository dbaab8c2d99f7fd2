// How long a worker spins: dxPatience.
#include "threading/pool/dxPatience.h"

#include <gtest/gtest.h>

namespace {

using std::chrono::microseconds;

TEST(Patience, IsShortWithoutExperience) { EXPECT_EQ(dxPatience().spinTime(), dxSpinTime); }

TEST(Patience, CoversTheLongestOfRecentWaits) {
    dxPatience patience;
    for (int frame = 0; frame < 100; ++frame) {
        patience.remember(microseconds(5));  // between two stages of a frame
        patience.remember(microseconds(400));
    }
    EXPECT_GT(patience.spinTime(), microseconds(400));
    EXPECT_LT(patience.spinTime(), microseconds(600));
}

TEST(Patience, DoesNotSpinThroughLongWaits) {
    dxPatience patience;
    for (int frame = 0; frame < 100; ++frame) patience.remember(std::chrono::milliseconds(20));
    EXPECT_EQ(patience.spinTime(), dxSpinTime);
}

TEST(Patience, NeverSpinsLongerThanItsBound) {
    dxPatience patience;
    patience.remember(dxPatience::kLongest);
    EXPECT_EQ(patience.spinTime(), dxPatience::kLongest);
}

TEST(Patience, FadesWhenWaitsGetShort) {
    dxPatience patience;
    patience.remember(microseconds(900));
    for (int frame = 0; frame < 100; ++frame) patience.remember(microseconds(5));
    EXPECT_EQ(patience.spinTime(), dxSpinTime);
}

}  // namespace
