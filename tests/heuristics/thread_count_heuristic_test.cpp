// Threads as many as clusters: never more than the limit, never none.
#include "clusters/heuristics/dxThreadCountHeuristic.h"

#include <gtest/gtest.h>

#include "AlertLog.h"

namespace {

unsigned threadsFor(dxThreadCountHeuristic &heuristic, unsigned clusters, unsigned limit) {
    heuristic.observe(clusters, limit);
    heuristic.tick();
    return heuristic.threads();
}

TEST(ThreadCountHeuristic, FollowsTheClustersWithinTheLimits) {
    dxThreadCountHeuristic heuristic;
    heuristic.start();
    EXPECT_EQ(threadsFor(heuristic, 3, 8), 3u);
    EXPECT_EQ(threadsFor(heuristic, 8, 8), 8u);
    EXPECT_EQ(threadsFor(heuristic, 4000000000u, 8), 8u);
    EXPECT_EQ(threadsFor(heuristic, 0, 8), 1u);
    EXPECT_EQ(threadsFor(heuristic, 5, 1), 1u);
    EXPECT_EQ(threadsFor(heuristic, 5, 0), 1u);
    EXPECT_EQ(threadsFor(heuristic, 0, 0), 1u);
}

TEST(ThreadCountHeuristic, ASmallerLimitHoldsAtOnce) {
    dxThreadCountHeuristic heuristic;
    heuristic.start();
    EXPECT_EQ(threadsFor(heuristic, 6, 8), 6u);
    heuristic.observe(6, 2);
    EXPECT_EQ(heuristic.threads(), 2u);
}

TEST(ThreadCountHeuristic, TellsOfItsChanges) {
    AlertLog log;
    dxThreadCountHeuristic heuristic;
    heuristic.setAlertCallback(&log);
    heuristic.start();
    for (const unsigned clusters : {2u, 2u, 3u, 3u, 2u}) threadsFor(heuristic, clusters, 8);
    EXPECT_EQ(log.numbers, (std::vector<double>{2, 3, 2}));
}

TEST(ThreadCountHeuristic, GivesTheLimitWhileItDoesNotRun) {
    dxThreadCountHeuristic heuristic;
    EXPECT_EQ(threadsFor(heuristic, 2, 8), 8u);
    EXPECT_EQ(dxThreadCountHeuristic().threads(), 1u);
    heuristic.start();
    EXPECT_EQ(heuristic.threads(), 8u) << "nothing was judged yet";
    EXPECT_EQ(threadsFor(heuristic, 2, 8), 2u);
    heuristic.pause();
    EXPECT_EQ(heuristic.threads(), 8u);
    heuristic.start();
    EXPECT_EQ(heuristic.threads(), 2u);
    heuristic.reset();
    heuristic.start();
    EXPECT_EQ(heuristic.threads(), 8u);
}

}  // namespace
