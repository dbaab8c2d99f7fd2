// Each kind of alert on sequences of values.
#include "heuristics/dxHeuristicAlert.h"

#include <gtest/gtest.h>

#include <limits>

#include "AlertLog.h"

namespace {

using Alert = dxHeuristicAlert;
using Frames = std::vector<std::uint64_t>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Frames in which the alert comes.
Frames framesOf(const Alert &alert, const std::vector<double> &values, unsigned window = 2) {
    dxHeuristic<double> heuristic(0, window);
    AlertLog<double> log;
    EXPECT_NE(heuristic.addAlert(alert, log), 0u);
    heuristic.start();
    run(heuristic, values);
    return log.frames;
}

TEST(HeuristicAlert, FixedIntervalComesExactlyEveryNthFrame) {
    const std::vector<double> values(30);
    EXPECT_EQ(framesOf(Alert::everyFrames(10), values), (Frames{10, 20, 30}));
    EXPECT_EQ(framesOf(Alert::everyFrames(7), values), (Frames{7, 14, 21, 28}));
    EXPECT_EQ(framesOf(Alert::everyFrames(1), values).size(), 30u);
    EXPECT_EQ(framesOf(Alert::everyFrames(31), values), Frames{});
    EXPECT_EQ(framesOf(Alert::everyFrames(std::numeric_limits<unsigned>::max()), values), Frames{});
}

TEST(HeuristicAlert, FixedIntervalLeavesPausesOutAndBeginsAgainAfterAReset) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> log;
    heuristic.addAlert(Alert::everyFrames(3), log);
    heuristic.start();
    run(heuristic, {0, 0});
    heuristic.pause();
    run(heuristic, {0, 0, 0, 0});
    heuristic.start();
    EXPECT_TRUE(log.frames.empty());
    run(heuristic, {0});
    EXPECT_EQ(log.frames, Frames{3});
    run(heuristic, {0, 0});
    heuristic.reset();
    heuristic.start();
    run(heuristic, {0, 0});
    EXPECT_EQ(log.frames, Frames{3});
    run(heuristic, {0});
    EXPECT_EQ(log.frames, (Frames{3, 3}));
}

TEST(HeuristicAlert, ValueChangeComparesWithTheFrameBefore) {
    EXPECT_EQ(framesOf(Alert::valueChange(), {5, 5, 6, 6, 5, 5}), (Frames{3, 5}));
    EXPECT_EQ(framesOf(Alert::valueChange(), {5}), Frames{}) << "nothing was before";
    EXPECT_EQ(framesOf(Alert::valueChange(), {0.0, -0.0}), Frames{});
    EXPECT_EQ(framesOf(Alert::valueChange(), {1, kNaN, kNaN, 1, kInfinity, kInfinity}), (Frames{2, 4, 5}));
}

TEST(HeuristicAlert, AResetForgetsTheFrameBefore) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> log;
    heuristic.addAlert(Alert::valueChange(), log);
    heuristic.start();
    run(heuristic, {5, 5});
    heuristic.reset();
    heuristic.start();
    run(heuristic, {9, 9});
    EXPECT_EQ(log.frames, Frames{});
}

TEST(HeuristicAlert, ThresholdsOfTheValueAreTriggeredByTheEdge) {
    EXPECT_EQ(framesOf(Alert::valueBelow(3), {5, 3, 2, 1, 3, 2}), (Frames{3, 6}));
    EXPECT_EQ(framesOf(Alert::valueAbove(3), {1, 3, 4, 9, 3, 4}), (Frames{3, 6}));
    EXPECT_EQ(framesOf(Alert::valueBelow(3), {1, 1}), Frames{1}) << "below from the start";
    EXPECT_EQ(framesOf(Alert::valueAbove(kInfinity), {kInfinity, 1e308}), Frames{});
    EXPECT_EQ(framesOf(Alert::valueAbove(0), {kInfinity, -kInfinity, kInfinity}), (Frames{1, 3}));
}

TEST(HeuristicAlert, ThresholdsOfTheSpeedAreTriggeredByTheEdge) {
    EXPECT_EQ(framesOf(Alert::speedAbove(2), {0, 2, 5, 9, 9, 12}), (Frames{3, 6}));
    EXPECT_EQ(framesOf(Alert::speedBelow(-2), {0, -2, -5, -9, -9, -12}), (Frames{3, 6}));
    EXPECT_EQ(framesOf(Alert::speedBelow(1), {0, 5}), Frames{1})
        << "the speed is 0 before there are two samples";
}

TEST(HeuristicAlert, NaNIsNeitherBelowNorAboveAndLeavesTheEdge) {
    EXPECT_EQ(framesOf(Alert::valueBelow(3), {kNaN, kNaN, 1, kNaN, 1, 5, kNaN, 1}), (Frames{3, 8}));
    EXPECT_EQ(framesOf(Alert::valueAbove(3), {kNaN, 5, kNaN, 5}), Frames{2});
    EXPECT_EQ(framesOf(Alert::speedAbove(0), {kInfinity, kInfinity, kNaN}), Frames{});
}

TEST(HeuristicAlert, AnAlertThatMeansNothingIsRefused) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> log;
    EXPECT_EQ(heuristic.addAlert(Alert::everyFrames(0), log), 0u);
    EXPECT_EQ(heuristic.addAlert(Alert::valueBelow(kNaN), log), 0u);
    EXPECT_EQ(heuristic.addAlert(Alert::valueAbove(kNaN), log), 0u);
    EXPECT_EQ(heuristic.addAlert(Alert::speedBelow(kNaN), log), 0u);
    EXPECT_EQ(heuristic.addAlert(Alert::speedAbove(kNaN), log), 0u);
    EXPECT_EQ(heuristic.alerts(), 0u);
    EXPECT_FALSE(Alert::everyFrames(0).fires({5, 0, 0, 0}));
}

TEST(HeuristicAlert, AResetArmsTheEdgeAgain) {
    dxHeuristic<double> heuristic(9);
    AlertLog<double> log;
    heuristic.addAlert(Alert::valueAbove(3), log);
    heuristic.start();
    run(heuristic, {5, 5});
    heuristic.reset();
    heuristic.start();
    heuristic.tick();
    EXPECT_EQ(log.frames, (Frames{1, 1}));
}

}  // namespace
