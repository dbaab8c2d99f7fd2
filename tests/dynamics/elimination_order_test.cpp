// The symbolic factorisation: each body has a place, the factor has a block wherever elimination makes one, and there are as few
// as there can be where that is known.
#include "dynamics/world_step/fast/dxEliminationOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace {

using Pairs = std::vector<std::pair<unsigned, unsigned>>;
using Blocks = std::set<std::pair<unsigned, unsigned>>;  // row, column, by places

Blocks blocksOf(const dxEliminationOrder &order) {
    Blocks blocks;
    for (unsigned column = 0; column < order.bodyCount(); ++column)
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block) {
            EXPECT_EQ(order.findBlock(order.rowOf(block), column), block);
            blocks.emplace(order.rowOf(block), column);
        }
    return blocks;
}

// What elimination in this order leaves, by its definition.
Blocks eliminate(const dxEliminationOrder &order, const Pairs &pairs) {
    Blocks blocks;
    for (const auto &[a, b] : pairs)
        blocks.emplace(std::max(order.placeOf(a), order.placeOf(b)), std::min(order.placeOf(a), order.placeOf(b)));
    for (unsigned column = 0; column < order.bodyCount(); ++column)
        for (unsigned row = column + 1; row < order.bodyCount(); ++row)
            for (unsigned other = row + 1; other < order.bodyCount(); ++other)
                if (blocks.count({row, column}) != 0 && blocks.count({other, column}) != 0) blocks.emplace(other, row);
    return blocks;
}

void expectConsistent(const dxEliminationOrder &order, unsigned bodies, const Pairs &pairs) {
    std::set<unsigned> places;
    for (unsigned body = 0; body < bodies; ++body) places.insert(order.placeOf(body));
    EXPECT_EQ(places.size(), bodies);
    EXPECT_TRUE(places.empty() || *places.rbegin() == bodies - 1);
    const Blocks blocks = blocksOf(order);
    EXPECT_EQ(blocks, eliminate(order, pairs));
    EXPECT_EQ(blocks.size(), order.blockCount());
    Blocks entries;
    for (unsigned row = 0; row < bodies; ++row)
        for (unsigned e = order.firstEntry(row); e < order.firstEntry(row + 1); ++e) {
            EXPECT_EQ(order.rowOf(order.entry(e).block), row);
            EXPECT_TRUE(e == order.firstEntry(row) || order.entry(e - 1).column < order.entry(e).column);
            entries.emplace(row, order.entry(e).column);
        }
    EXPECT_EQ(entries, blocks);
}

TEST(EliminationOrder, HasABlockWhereverEliminationMakesOne) {
    dxEliminationOrder order;  // its memory is used again
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const unsigned bodies = 1 + random() % 30;
        Pairs pairs;
        for (unsigned i = random() % (3 * bodies); i > 0; --i) {
            const unsigned a = random() % bodies, b = random() % bodies;
            if (a != b) pairs.emplace_back(a, b);
        }
        order.find(bodies, pairs);
        expectConsistent(order, bodies, pairs);
    }
}

TEST(EliminationOrder, TreesHaveNoFill) {
    Pairs chain, star;
    for (unsigned i = 1; i < 100; ++i) {
        chain.emplace_back(i - 1, i);
        star.emplace_back(i, 0);
    }
    for (const Pairs &pairs : {chain, star}) {
        dxEliminationOrder order;
        order.find(100, pairs);
        EXPECT_EQ(order.blockCount(), 99u);
    }
}

TEST(EliminationOrder, OfNoBodyIsEmpty) {
    dxEliminationOrder order;
    order.find(0, {});
    EXPECT_EQ(order.bodyCount(), 0u);
    EXPECT_EQ(order.blockCount(), 0u);
}

}  // namespace
