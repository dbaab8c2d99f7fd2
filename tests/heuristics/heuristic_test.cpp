// dxHeuristic: a value, its samples, average and speed.
#include "heuristics/dxHeuristic.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "AlertLog.h"

namespace {

TEST(Heuristic, StartsWithItsValueAndNoSamples) {
    const dxHeuristic<int> heuristic(42);
    EXPECT_EQ(heuristic.state(), dxHeuristicState::Init);
    EXPECT_EQ(heuristic.value(), 42);
    EXPECT_EQ(heuristic.samples(), 0u);
    EXPECT_EQ(heuristic.average(), 0);
    EXPECT_EQ(heuristic.speed(), 0);
    EXPECT_EQ(heuristic.window(), dxHeuristic<int>::kDefaultWindow);
}

TEST(Heuristic, TakesOneSampleAFrameWhateverIsSetInBetween) {
    dxHeuristic<int> heuristic(0);
    heuristic.start();
    heuristic.setValue(100);
    heuristic.setValue(4);
    heuristic.tick();
    EXPECT_EQ(heuristic.samples(), 1u);
    EXPECT_EQ(heuristic.average(), 4);
    heuristic.tick();
    EXPECT_EQ(heuristic.samples(), 2u);
    EXPECT_EQ(heuristic.average(), 4) << "the value stays until it is set again";
}

TEST(Heuristic, AverageAndSpeedCoverTheWindow) {
    dxHeuristic<int> heuristic(0, 4);
    heuristic.start();
    run(heuristic, {1000, 2, 4, 6, 8});
    EXPECT_DOUBLE_EQ(heuristic.average(), 5);
    EXPECT_DOUBLE_EQ(heuristic.speed(), 2);
}

TEST(Heuristic, UnsignedValuesMayFall) {
    dxHeuristic<unsigned> heuristic(0, 2);
    heuristic.start();
    run(heuristic, {10u, 7u});
    EXPECT_DOUBLE_EQ(heuristic.speed(), -3);
}

TEST(Heuristic, ExtremeIntegersDoNotOverflow) {
    using Limits = std::numeric_limits<std::int64_t>;
    dxHeuristic<std::int64_t> heuristic(0, 2);
    heuristic.start();
    run(heuristic, {Limits::min(), Limits::max()});
    EXPECT_DOUBLE_EQ(heuristic.speed(), 18446744073709551616.0);
    EXPECT_NEAR(heuristic.average(), 0, 1);
}

TEST(Heuristic, PauseKeepsEverythingResetForgetsStopCanBeRead) {
    dxHeuristic<int> heuristic(7, 3);
    heuristic.start();
    run(heuristic, {1, 2, 3});
    heuristic.pause();
    run(heuristic, {100});
    EXPECT_DOUBLE_EQ(heuristic.average(), 2);
    heuristic.stop();
    EXPECT_DOUBLE_EQ(heuristic.average(), 2);
    EXPECT_EQ(heuristic.samples(), 3u);
    heuristic.reset();
    EXPECT_EQ(heuristic.value(), 7);
    EXPECT_EQ(heuristic.samples(), 0u);
    EXPECT_EQ(heuristic.average(), 0);
    EXPECT_EQ(heuristic.speed(), 0);
}

TEST(Heuristic, ARuleMayTuneTheValueFromACallback) {
    struct Raise : HeuristicAlertCallback<int> {
        void alertCallback(dxHeuristic<int> &cells, const dxHeuristicAlert &) override {
            cells.setValue(cells.value() + 1);
        }
    } raise;
    dxHeuristic<int> cells(5);
    cells.addAlert(dxHeuristicAlert::everyFrames(10), raise);
    cells.start();
    for (int frame = 0; frame < 150; ++frame) cells.tick();
    EXPECT_EQ(cells.value(), 20) << "the thesis's cell count after 150 frames";
}

}  // namespace
