// dxDisjointSets against sets kept by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "core/dxDisjointSets.h"

namespace {

TEST(DisjointSets, EachElementBeginsAlone) {
    dxDisjointSets sets;
    sets.reset(4);
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, TheLowestElementStandsForTheSet) {
    dxDisjointSets sets;
    sets.reset(6);
    sets.unite(5, 3);
    sets.unite(4, 5);
    EXPECT_EQ(sets.find(5), 3u);
    EXPECT_EQ(sets.find(4), 3u);
    sets.unite(1, 4);
    for (const std::uint32_t i : {1u, 3u, 4u, 5u}) EXPECT_EQ(sets.find(i), 1u);
    EXPECT_EQ(sets.find(0), 0u);
    EXPECT_EQ(sets.find(2), 2u);
}

TEST(DisjointSets, ResetForgets) {
    dxDisjointSets sets;
    sets.reset(3);
    sets.unite(0, 2);
    sets.reset(5);
    for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, AgreeWithLabelsWhateverTheOrder) {
    constexpr std::uint32_t kElements = 200;
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::uint32_t> label(kElements);
        for (std::uint32_t i = 0; i < kElements; ++i) label[i] = i;
        dxDisjointSets sets;
        sets.reset(kElements);
        for (unsigned k = random() % 300; k > 0; --k) {
            const std::uint32_t a = random() % kElements, b = random() % kElements;
            sets.unite(a, b);
            const std::uint32_t low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
            std::replace(label.begin(), label.end(), high, low);
        }
        for (std::uint32_t i = 0; i < kElements; ++i) ASSERT_EQ(sets.find(i), label[i]);
    }
}

// A chain of a million takes no stack.
TEST(DisjointSets, ALongChainIsNoRecursion) {
    constexpr std::uint32_t kElements = 1000000;
    dxDisjointSets sets;
    sets.reset(kElements);
    for (std::uint32_t i = kElements - 1; i > 0; --i) sets.unite(i, i - 1);
    EXPECT_EQ(sets.find(kElements - 1), 0u);
}

}  // namespace
