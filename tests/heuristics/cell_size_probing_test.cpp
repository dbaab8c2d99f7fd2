// The cell size rule after its climb: when it probes, what that costs at most, where it moves.
#include "clusters/heuristics/dxCellSizeHeuristic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "CellWorld.h"

namespace {

using Rule = dxCellSizeHeuristic;
using Phase = Rule::Phase;

constexpr int kMin = Rule::kMinCells, kMax = Rule::kMaxCells;

TEST(CellSizeProbing, HoldsWithoutProbingWhileTheCostIsTheSame) {
    CellWorld world(valley(9));
    world.climb();
    for (int i = 0; i < 20000; ++i) {
        world.frame();
        ASSERT_EQ(world.rule.cells(), 9);
    }
}

TEST(CellSizeProbing, OneMoreObjectDoesNotStartOver) {
    CellWorld world(valley(9));
    world.entities = 100;
    world.climb();
    world.entities = 101;
    world.setCost([](int cells) { return 1.02 * valley(9)(cells); });
    for (int i = 0; i < 20000; ++i) {
        world.frame();
        ASSERT_EQ(world.rule.cells(), 9);
    }
}

TEST(CellSizeProbing, ADriftBeyondTheShareTriesBothNeighbours) {
    for (const double factor : {1 - Rule::kDrift - 0.01, 1 - Rule::kDrift + 0.01, 1 + Rule::kDrift - 0.01,
                                1 + Rule::kDrift + 0.01}) {
        CellWorld world(valley(9));
        world.climb();
        world.setCost([=](int cells) { return factor * valley(9)(cells); });
        std::set<int> tried;
        for (int i = 0; i < 1000; ++i) {
            world.frame();
            tried.insert(world.rule.cells());
        }
        const bool drifted = std::abs(factor - 1) > Rule::kDrift;
        EXPECT_EQ(tried, drifted ? (std::set<int>{8, 9, 10}) : std::set<int>{9}) << factor;
        EXPECT_EQ(world.rule.cells(), 9);
    }
}

TEST(CellSizeProbing, WalksToANewCheapestAndStaysThere) {
    CellWorld world(valley(8, 0.1));
    world.climb();
    ASSERT_EQ(world.rule.cells(), 8);
    world.setCost(valley(15, 0.1));
    world.frames(20000);
    EXPECT_EQ(world.rule.cells(), 15);
    world.setCost(valley(kMin, 0.2));
    world.frames(60000);
    EXPECT_EQ(world.rule.cells(), kMin);
}

TEST(CellSizeProbing, ASmallGainIsNotWorthANewGrid) {
    CellWorld world(valley(9, 0.01));
    world.climb();
    ASSERT_EQ(world.rule.cells(), 9);
    world.setCost([](int cells) { return 2 * valley(12, 0.01)(cells); });
    world.frames(2000);
    EXPECT_EQ(world.rule.cells(), 9);
}

TEST(CellSizeProbing, ProbesAtTheEndsOfTheRangeStayInIt) {
    for (const int end : {kMin, kMax}) {
        CellWorld world(valley(end));
        world.climb();
        unsigned frame = 0;
        world.setCost([&](int cells) { return valley(end)(cells) * (++frame / 500 % 2 == 0 ? 1 : 3); });
        std::set<int> tried;
        for (int i = 0; i < 20000; ++i) {
            world.frame();
            tried.insert(world.rule.cells());
        }
        EXPECT_GT(tried.size(), 1u);
        EXPECT_TRUE(*tried.begin() >= kMin && *tried.rbegin() <= kMax);
    }
}

TEST(CellSizeProbing, ProbingIsBoundedWhateverTheCosts) {
    std::mt19937 random(3);
    for (const unsigned interval : {1u, 4u, 16u}) {
        CellWorld world([&](int) { return std::exp(random() % 10); }, interval);
        world.climb();
        unsigned held = 0, probed = 0, probes = 0;
        for (int i = 0; i < 200000; ++i) {
            world.frame();
            if (world.rule.phase() == Phase::Hold) {
                if (probed > 0) held = 0;
                probed = 0;
                ++held;
                continue;
            }
            if (probed == 0) {
                ++probes;
                ASSERT_GE(held, Rule::kMinHold * interval);
            }
            ASSERT_LE(++probed, 2 * (interval + 1));
        }
        EXPECT_GT(probes, 10u);
    }
}

TEST(CellSizeProbing, FruitlessProbesBecomeRare) {
    double load = 1;
    CellWorld world([&](int cells) { return load * valley(9)(cells); });
    world.climb();
    unsigned away = 0;
    const auto awayIn = [&](unsigned frames) {
        away = 0;
        for (unsigned i = 0; i < frames; ++i) {
            if (i % 300 == 0) load = load == 1 ? 2 : 1;  // the load never settles
            world.frame();
            away += world.rule.cells() != 9;
        }
        return away;
    };
    EXPECT_LT(awayIn(20000), 20000u / 8);
    awayIn(100000);
    EXPECT_LT(awayIn(100000), 100000u / 250);
    EXPECT_EQ(world.rule.cells(), 9);
}

}  // namespace
