// The cell size rule on invented worlds whose cost is known: the climb, and odd input.
#include "clusters/heuristics/dxCellSizeHeuristic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "CellWorld.h"

namespace {

using Rule = dxCellSizeHeuristic;
using Phase = Rule::Phase;

constexpr int kMin = Rule::kMinCells, kMax = Rule::kMaxCells;

TEST(CellSizeHeuristic, StartsAtTheMinimum) {
    EXPECT_EQ(Rule().cells(), 5);
    EXPECT_EQ(Rule().phase(), Phase::Climb);
}

TEST(CellSizeHeuristic, RaisesByOneAfterEachInterval) {
    CellWorld world(valley(12, 0.01));
    for (int cells = kMin; cells <= kMax; ++cells) {
        for (unsigned i = 0; i < Rule::kDefaultInterval + 1; ++i) {  // the first pays for the new grid
            ASSERT_EQ(world.rule.cells(), cells);
            world.frame();
        }
    }
    EXPECT_EQ(world.rule.phase(), Phase::Hold);
    EXPECT_EQ(world.rule.cells(), 12);
}

TEST(CellSizeHeuristic, AnIntervalOfNoFramesIsOneFrame) {
    CellWorld none(valley(9), 0), one(valley(9), 1);
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(none.rule.cells(), one.rule.cells()) << i;
        none.frame();
        one.frame();
    }
}

TEST(CellSizeHeuristic, EndsAtTheCheapestWhereverItLies) {
    for (int best = kMin; best <= kMax; ++best) {
        CellWorld world(valley(best, 0.02));
        world.climb();
        EXPECT_EQ(world.rule.cells(), best);
        EXPECT_NEAR(world.rule.cost(best), 1e5, 1);
    }
}

TEST(CellSizeHeuristic, TheClimbEndsWhenThereAreAsManyClustersAsEntities) {
    CellWorld world(valley(7));
    world.entities = 9;
    world.clusters = [](int cells) { return static_cast<unsigned>(cells); };
    std::set<int> tried;
    for (int i = 0; i < 200; ++i) {
        tried.insert(world.rule.cells());
        world.frame();
    }
    EXPECT_EQ(tried, (std::set<int>{5, 6, 7, 8, 9}));
    EXPECT_EQ(world.rule.cells(), 7) << "cheapest, though 9 separates more";
}

TEST(CellSizeHeuristic, EqualCostsAreSettledByTheSmallerGrid) {
    CellWorld world([](int) { return 1e5; });
    world.climb();
    EXPECT_EQ(world.rule.cells(), kMin);
}

TEST(CellSizeHeuristic, DearCandidatesAreLeftEarlyAndTwoInARowEndTheClimb) {
    CellWorld world([](int cells) { return cells <= 6 ? 1e5 : 1e6; });
    const unsigned frames = world.climb();
    EXPECT_EQ(frames, 2 * (Rule::kDefaultInterval + 1) + 2 * (Rule::kTrialFrames + 1));
    EXPECT_EQ(world.rule.cells(), 5);
    EXPECT_TRUE(std::isinf(world.rule.cost(7)));
    EXPECT_EQ(world.rule.cost(9), 0) << "never tried";
}

TEST(CellSizeHeuristic, OneDearCandidateDoesNotEndTheClimb) {
    CellWorld world([](int cells) { return cells == 8 ? 1e7 : 1e5 * (30 - cells); });
    world.climb();
    EXPECT_EQ(world.rule.cells(), kMax);
}

// The system took the thread off its core in some frames.
TEST(CellSizeHeuristic, OddFramesDoNotDecide) {
    std::mt19937 random(5);
    CellWorld world([&](int cells) { return valley(11)(cells) * (random() % 8 == 0 ? 100 : 1); });
    world.climb();
    EXPECT_EQ(world.rule.cells(), 11);
}

TEST(CellSizeHeuristic, TheClimbIsBoundedWhateverTheCosts) {
    std::mt19937 random(9);
    for (const unsigned interval : {0u, 1u, 2u, 16u, 50u}) {
        for (int i = 0; i < 200; ++i) {
            CellWorld world([&](int) { return 1.0 + random() % 1000; }, interval);
            EXPECT_LE(world.climb(), 16 * (std::max(interval, 1u) + 1));
        }
    }
}

// The bound of the header, in worlds that change as badly as can be.
TEST(CellSizeHeuristic, FramesThatWereNotMeasuredDoNotCount) {
    CellWorld world(valley(9));
    world.frames(5);
    for (const double odd :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        for (int i = 0; i < 100; ++i) {
            world.rule.observe({odd, 1, 1});
            world.rule.tick();
        }
    }
    for (int i = 0; i < 100; ++i) world.rule.tick();  // nothing observed
    EXPECT_EQ(world.rule.cells(), kMin);
    world.climb();
    EXPECT_EQ(world.rule.cells(), 9);
}

TEST(CellSizeHeuristic, PauseKeepsTheCellsResetStartsOver) {
    CellWorld world(valley(9));
    world.climb();
    world.rule.pause();
    world.setCost(valley(20, 0.5));
    world.frames(2000);
    EXPECT_EQ(world.rule.cells(), 9);
    world.rule.reset();
    EXPECT_EQ(world.rule.cells(), kMin);
    EXPECT_EQ(world.rule.phase(), Phase::Climb);
    EXPECT_EQ(world.rule.cost(9), 0);
    world.rule.start();
    world.climb();
    EXPECT_EQ(world.rule.cells(), 20);
}

// The first frame pays for the new grid, also if it has as many cells as the old one.
TEST(CellSizeHeuristic, TheFirstFrameAfterAResetIsNotCounted) {
    CellWorld world(valley(9));
    world.frames(5);
    world.rule.reset();
    world.rule.start();
    world.frames(Rule::kDefaultInterval);
    EXPECT_EQ(world.rule.cells(), kMin);
    world.frame();
    EXPECT_EQ(world.rule.cells(), kMin + 1);
}

TEST(CellSizeHeuristic, CostsOfCellsOutsideTheRangeAreZero) {
    CellWorld world(valley(9));
    world.climb();
    for (const int cells : {-1000000000, 0, 4, 21, 1000000000}) EXPECT_EQ(world.rule.cost(cells), 0);
}

}  // namespace
