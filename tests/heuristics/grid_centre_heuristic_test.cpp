// When the centre moves, when it stays, and how often it is looked at.
#include "clusters/heuristics/dxGridCentreHeuristic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using Rule = dxGridCentreHeuristic;
using Point = Rule::Point;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEdge = 1;  // m

// A grid around the origin, as the frame would use the rule.
struct Grid {
    Grid() {
        rule.start();
        frame({0, 1e5}, {0, 0, 0});
    }

    // True: the centre moved.
    bool frame(const Rule::Frame &seen, const Point &median) {
        rule.observe(seen);
        rule.tick();
        if (!rule.wantsCentre()) return false;
        ++medians;
        const bool moved = rule.offer(median, kEdge);
        moves += moved;
        return moved;
    }
    void frames(unsigned count, const Rule::Frame &seen, const Point &median) {
        for (unsigned i = 0; i < count; ++i) frame(seen, median);
    }

    Rule rule;
    unsigned medians = 0, moves = 0;
};

TEST(GridCentreHeuristic, TheFirstMedianIsTaken) {
    Rule rule;
    EXPECT_EQ(rule.centre(), (Point{0, 0, 0}));
    EXPECT_FALSE(rule.offer({1, 2, 3}, kEdge)) << "not running";
    rule.start();
    EXPECT_FALSE(rule.offer({1, 2, 3}, kEdge)) << "not wanted yet";
    rule.tick();
    EXPECT_TRUE(rule.wantsCentre());
    EXPECT_TRUE(rule.offer({0.1, 0.2, 0.3}, kEdge)) << "within a cell of the origin, still";
    EXPECT_EQ(rule.centre(), (Point{0.1, 0.2, 0.3}));
    EXPECT_FALSE(rule.wantsCentre());
    EXPECT_FALSE(rule.offer({9, 9, 9}, kEdge)) << "not wanted any more";
}

TEST(GridCentreHeuristic, StaysWhileMembersAreInsideAndCostIsTheSame) {
    Grid grid;
    grid.frames(5000, {Rule::kOutside, 1e5}, {50, 50, 50});
    EXPECT_EQ(grid.medians, 1u);
    EXPECT_EQ(grid.rule.centre(), (Point{0, 0, 0}));
}

TEST(GridCentreHeuristic, MovesWhenTooManyMembersAreOutside) {
    for (int axis = 0; axis < 3; ++axis) {
        Point median{};
        median[axis] = -5;
        Grid grid;
        grid.frames(Rule::kMinRest, {Rule::kOutside + 0.01, 1e5}, median);
        EXPECT_EQ(grid.rule.centre(), median);
    }
}

TEST(GridCentreHeuristic, MovesWhenTheFrameBecomesDearer) {
    for (const double factor : {1 + Rule::kDrift - 0.01, 1 + Rule::kDrift + 0.01}) {
        Grid grid;
        grid.frames(100, {0, 1e5}, {0, 0, 0});
        grid.frames(100, {0, factor * 1e5}, {5, 0, 0});
        EXPECT_EQ(grid.rule.centre()[0], factor > 1 + Rule::kDrift ? 5 : 0) << factor;
    }
}

TEST(GridCentreHeuristic, ACheaperFrameOrOneOddFrameIsNoReason) {
    Grid grid;
    grid.frames(100, {0, 1e5}, {0, 0, 0});
    for (int i = 0; i < 1000; ++i) grid.frame({0, i % 5 == 0 ? 1e9 : 1e4}, {5, 0, 0});
    EXPECT_EQ(grid.medians, 1u);
}

// After a decision costs are compared with those that follow it.
TEST(GridCentreHeuristic, AFrameThatStaysDearerIsAReasonOnce) {
    Grid grid;
    grid.frames(1000, {0, 1e5}, {0, 0, 0});
    grid.frames(20 * Rule::kMaxRest, {0, 3e5}, {0, 0, 0});
    EXPECT_EQ(grid.medians, 2u);
}

TEST(GridCentreHeuristic, AMoveWithinACellIsNotMade) {
    Grid near, far;
    near.frames(100, {1, 1e5}, {kEdge, -kEdge, kEdge});
    EXPECT_EQ(near.moves, 1u) << "the first placing only";
    far.frames(100, {1, 1e5}, {0, 0, 1.01 * kEdge});
    EXPECT_EQ(far.moves, 2u);
}

TEST(GridCentreHeuristic, FollowsACrowdThatWalks) {
    Grid grid;
    for (int i = 0; i < 10000; ++i) {
        const double crowd = 0.01 * i;
        grid.frame({std::abs(crowd - grid.rule.centre()[0]) > 3 ? 1.0 : 0.0, 1e5}, {crowd, 0, 0});
        ASSERT_LT(std::abs(crowd - grid.rule.centre()[0]), 3 + 0.01 * 2 * Rule::kMinRest);
    }
    EXPECT_GT(grid.moves, 20u);
    EXPECT_LT(grid.moves, 40u) << "once in three metres or a little more";
}

TEST(GridCentreHeuristic, NoTwoDecisionsAreCloserThanTheRest) {
    Grid grid;
    unsigned since = 0;
    for (int i = 0; i < 10000; ++i) {
        const unsigned before = grid.medians;
        grid.frame({1, 1e5}, {i % 2 == 0 ? 10.0 : -10.0, 0, 0});
        ++since;
        if (grid.medians == before) continue;
        ASSERT_GE(since, Rule::kMinRest);
        since = 0;
    }
}

TEST(GridCentreHeuristic, AReasonThatMovingDoesNotCureIsLookedAtEverLess) {
    Grid grid;
    grid.frames(100000, {0.5, 1e5}, {0, 0, 0});
    EXPECT_EQ(grid.rule.rest(), Rule::kMaxRest);
    EXPECT_LT(grid.medians, 100000 / Rule::kMaxRest + 10);
    EXPECT_EQ(grid.moves, 1u);
    grid.frames(2 * Rule::kMaxRest, {0, 1e5}, {0, 0, 0});
    EXPECT_EQ(grid.rule.rest(), Rule::kMinRest) << "the reason has gone";
}

TEST(GridCentreHeuristic, OddNumbersMoveNothing) {
    for (const double odd : {kNaN, kInfinity, -kInfinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            Point median = {5, 5, 5};
            median[axis] = odd;
            Grid grid;
            grid.frames(200, {1, 1e5}, median);
            EXPECT_EQ(grid.rule.centre(), (Point{0, 0, 0})) << odd;
        }
        Grid grid;
        grid.frames(1000, {odd > 0 ? 0 : odd, odd}, {5, 5, 5});
        EXPECT_EQ(grid.medians, 1u) << odd;
    }
    for (const double edge : {0.0, -1.0, kNaN, kInfinity}) {
        Rule rule;
        rule.start();
        rule.tick();
        EXPECT_FALSE(rule.offer({5, 5, 5}, edge));
        rule.tick();
        EXPECT_TRUE(rule.wantsCentre()) << "there is no centre yet";
    }
}

TEST(GridCentreHeuristic, PauseKeepsTheCentreResetForgetsIt) {
    Grid grid;
    grid.frames(Rule::kMinRest, {1, 1e5}, {7, 0, 0});
    ASSERT_EQ(grid.rule.centre()[0], 7);
    grid.rule.pause();
    grid.frames(5000, {1, 1e5}, {70, 0, 0});
    EXPECT_EQ(grid.rule.centre()[0], 7);
    EXPECT_FALSE(grid.rule.offer({70, 0, 0}, kEdge));
    grid.rule.reset();
    EXPECT_EQ(grid.rule.centre()[0], 0);
    grid.rule.start();
    grid.rule.tick();
    EXPECT_TRUE(grid.rule.wantsCentre());
}

}  // namespace
