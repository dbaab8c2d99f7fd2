// Every island is in one block; large islands alone and first, small ones together in their own order.
//
// Covers dxStepRecords.cpp.
#include "dynamics/step/dxIslandPreparation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace {

void fill(dxStepRecords &records, const std::vector<double> &costs) {
    records.islands.resize(costs.size());
    for (std::size_t i = 0; i < costs.size(); ++i) records.islands[i].cost = costs[i];
}

std::vector<std::vector<unsigned>> blocksOf(const dxStepRecords &records) {
    std::vector<std::vector<unsigned>> blocks;
    for (const dxIslandBlock block : records.blocks) {
        blocks.emplace_back(records.order.begin() + block.begin, records.order.begin() + block.end);
    }
    return blocks;
}

std::vector<std::vector<unsigned>> share(const std::vector<double> &costs, double least) {
    dxStepRecords records;
    fill(records, costs);
    dxCutIslandBlocks(records, static_cast<unsigned>(costs.size()), least);
    return blocksOf(records);
}

using Blocks = std::vector<std::vector<unsigned>>;

TEST(IslandBlocks, LargeIslandsComeFirstLargestFirst) {
    EXPECT_EQ(share({10, 30, 20}, 5), (Blocks{{1}, {2}, {0}}));
}

TEST(IslandBlocks, EqualIslandsKeepTheirOrder) { EXPECT_EQ(share({7, 7, 7}, 7), (Blocks{{0}, {1}, {2}})); }

TEST(IslandBlocks, SmallIslandsShareABlockInTheirOrder) {
    EXPECT_EQ(share({1, 2, 9, 1, 1, 3, 1}, 4), (Blocks{{2}, {0, 1, 3}, {4, 5}, {6}}));
}

TEST(IslandBlocks, OnlyIslandsBeforeTheEnd) {
    dxStepRecords records;
    fill(records, {1, 50, 1, 50});
    dxCutIslandBlocks(records, 3, 10);
    EXPECT_EQ(blocksOf(records), (Blocks{{1}, {0, 2}}));
    dxCutIslandBlocks(records, 0, 10);
    EXPECT_TRUE(records.blocks.empty());
    EXPECT_TRUE(records.order.empty());
}

class RandomIslands : public testing::TestWithParam<unsigned> {
protected:
    RandomIslands() : random(GetParam()) {
        std::lognormal_distribution<double> cost(8, 2);
        costs.resize(random() % 400);
        for (double &c : costs) c = random() % 10 == 0 ? 0 : cost(random);
        least = random() % 5 == 0 ? 0 : cost(random);
    }

    double costOf(const std::vector<unsigned> &block) const {
        return std::accumulate(block.begin(), block.end(), 0.0,
                               [this](double sum, unsigned island) { return sum + costs[island]; });
    }

    std::mt19937 random;
    std::vector<double> costs;
    double least;
};

TEST_P(RandomIslands, EveryIslandOnceInConsecutiveBlocks) {
    dxStepRecords records;
    fill(records, costs);
    dxCutIslandBlocks(records, static_cast<unsigned>(costs.size()), least);
    std::vector<unsigned> islands = records.order;
    std::sort(islands.begin(), islands.end());
    std::vector<unsigned> all(costs.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(islands, all);
    unsigned at = 0;
    for (const dxIslandBlock block : records.blocks) {
        EXPECT_EQ(block.begin, at);
        EXPECT_LT(block.begin, block.end);
        at = block.end;
    }
    EXPECT_EQ(at, records.order.size());
}

TEST_P(RandomIslands, BlocksAreWorthHandingOut) {
    const Blocks blocks = share(costs, least);
    for (std::size_t i = 0; i + 1 < blocks.size(); ++i) EXPECT_GE(costOf(blocks[i]), least) << "block " << i;
    for (const auto &block : blocks) {
        // Without its last island no block would be.
        const std::vector<unsigned> others(block.begin(), block.end() - 1);
        if (!others.empty()) {
            EXPECT_LT(costOf(others), least);
        }
    }
}

TEST_P(RandomIslands, LargeOnesAloneInDescendingOrderThenSmallOnesAscending) {
    const Blocks blocks = share(costs, least);
    std::size_t i = 0;
    double before = std::numeric_limits<double>::infinity();
    for (; i < blocks.size() && costs[blocks[i][0]] >= least; ++i) {
        EXPECT_EQ(blocks[i].size(), 1u);
        EXPECT_LE(costs[blocks[i][0]], before);
        before = costs[blocks[i][0]];
    }
    std::vector<unsigned> small;
    for (; i < blocks.size(); ++i) small.insert(small.end(), blocks[i].begin(), blocks[i].end());
    EXPECT_TRUE(std::is_sorted(small.begin(), small.end()));
    for (const unsigned island : small) EXPECT_LT(costs[island], least);
}

TEST_P(RandomIslands, TheSameFromReusedRecords) {
    dxStepRecords records;
    fill(records, std::vector<double>(500, 3));
    dxCutIslandBlocks(records, 500, 10);
    fill(records, costs);
    dxCutIslandBlocks(records, static_cast<unsigned>(costs.size()), least);
    EXPECT_EQ(blocksOf(records), share(costs, least));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomIslands, testing::Range(0u, 50u));

}  // namespace
