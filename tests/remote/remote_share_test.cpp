// What is predicted to pay: much work in several islands on fast links, and nothing else.
#include "remote/islands/dxRemoteShare.h"

#include <gtest/gtest.h>

namespace {

dxRemoteWork islandsOf(double ns, double count) {
    dxRemoteWork work;
    work.totalNs = ns * count;
    work.largestNs = ns;
    work.islands = count;
    work.joints = 40 * count;
    work.bodies = 12 * count;
    return work;
}

constexpr dxRemoteCapacity kNear{1, 1, 60e3, 0.3}, kMany{15, 15, 60e3, 0.3}, kFar{1, 1, 20e6, 10}, kNone{};

TEST(RemoteShare, HalfOfManyIslandsGoesToOneWorker) { EXPECT_NEAR(dxPredictRemoteShare(islandsOf(5e6, 16), 1, kNear), 0.5, 0.1); }
TEST(RemoteShare, MostGoesToManyWorkers) { EXPECT_GT(dxPredictRemoteShare(islandsOf(5e6, 64), 1, kMany), 0.7); }
TEST(RemoteShare, LessGoesWhereHomeHasThreads) {
    EXPECT_LT(dxPredictRemoteShare(islandsOf(5e6, 64), 8, kMany), dxPredictRemoteShare(islandsOf(5e6, 64), 1, kMany));
}
TEST(RemoteShare, SmallWorldsStay) {
    EXPECT_EQ(dxPredictRemoteShare(islandsOf(10e3, 8), 1, kNear), 0);
    EXPECT_EQ(dxPredictRemoteShare(islandsOf(1e6, 8), 1, kFar), 0);
}
TEST(RemoteShare, OneIslandStays) { EXPECT_EQ(dxPredictRemoteShare(islandsOf(5e6, 1), 1, kMany), 0); }
TEST(RemoteShare, WithoutWorkersAllStays) { EXPECT_EQ(dxPredictRemoteShare(islandsOf(5e6, 16), 1, kNone), 0); }

}  // namespace
