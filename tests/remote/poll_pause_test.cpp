// A message that is expected is seen soon, and one that is not is looked for seldom.
#include "remote/transport/dxPollPause.h"

#include <gtest/gtest.h>

namespace {

double nsOf(dxPollPause::Duration pause) { return static_cast<double>(pause.count()); }

TEST(PollPause, GrowsWithTheTimeWaited) {
    dxPollPause pause;
    double waited = 0, last = 0;
    for (int i = 0; i < 30000; ++i) {
        const double ns = nsOf(pause.next());
        EXPECT_GE(ns, last);
        EXPECT_LE(ns, dxPollPause::longestNs(waited));
        EXPECT_GE(ns, 20e3);
        if (waited > 160e3 && waited < 800e3) {
            EXPECT_LE(ns, waited / 8 + 1);
        }
        waited += ns;
        last = ns;
    }
    EXPECT_TRUE(dxPollPause::isLong(waited));
    EXPECT_EQ(last, dxPollPause::longestNs(waited));
}

TEST(PollPause, IsShortForASecond) {
    EXPECT_FALSE(dxPollPause::isLong(0.99e9));
    EXPECT_TRUE(dxPollPause::isLong(1e9));
    EXPECT_LE(dxPollPause::longestNs(0.99e9), 100e3);
    EXPECT_GE(dxPollPause::longestNs(1e9), 1e6);
}

TEST(PollPause, BeginsAnew) {
    dxPollPause pause;
    const dxPollPause::Duration first = pause.next();
    for (int i = 0; i < 1000; ++i) pause.next();
    EXPECT_GT(pause.next(), first);
    pause.reset();
    EXPECT_EQ(pause.next(), first);
}

}  // namespace
