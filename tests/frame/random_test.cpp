// The random sequence and its public calls, against Debian's library.
//
// Covers api/misc.cpp.
#include "dynamics/step/random/dxRandom.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <random>
#include <thread>
#include <vector>

#include "DebianOde.h"

namespace {

constexpr std::uint32_t kSeeds[] = {0, 1, 12345, 0x7fffffff, 0x80000000, 0xffffffff};

std::uint32_t nextRepeated(std::uint32_t seed, std::uint64_t times) {
    for (; times != 0; --times) seed = dxRandom::next(seed);
    return seed;
}

TEST(Random, JumpIsRepeatedNext) {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t seed = random();
        const std::uint64_t draws = i < 20 ? i : random() % 100000;
        ASSERT_EQ(dxRandom::jump(seed, draws), nextRepeated(seed, draws))
            << seed << ", " << draws << " draws";
    }
}

// The sequence has the period 2^32, so that far jumps follow from near ones.
TEST(Random, JumpsBeyondThePeriod) {
    constexpr std::uint64_t kPeriod = std::uint64_t{1} << 32;
    for (const std::uint32_t seed : kSeeds) {
        EXPECT_EQ(dxRandom::next(dxRandom::jump(seed, kPeriod - 1)), seed);
        EXPECT_EQ(dxRandom::jump(seed, kPeriod), seed);
        EXPECT_EQ(dxRandom::jump(seed, 5 * kPeriod + 777), nextRepeated(seed, 777));
    }
}

TEST(Random, JumpsAddUp) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 1000; ++i) {
        const std::uint32_t seed = static_cast<std::uint32_t>(random());
        const std::uint64_t a = random() >> 2, b = random() >> 2;
        ASSERT_EQ(dxRandom::jump(dxRandom::jump(seed, a), b), dxRandom::jump(seed, a + b));
    }
}

TEST(Random, SequenceIsDebians) {
    const auto setSeed = debianOde::function(dRandSetSeed, "dRandSetSeed");
    const auto draw = debianOde::function(dRand, "dRand");
    const auto seedOf = debianOde::function(dRandGetSeed, "dRandGetSeed");
    for (unsigned long seed : {0ul, 1ul, 4294967295ul, (1ul << 40) + 5}) {
        setSeed(seed);
        dRandSetSeed(seed);
        EXPECT_EQ(dRandGetSeed(), seedOf());
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(dRand(), draw());
        EXPECT_EQ(dRandGetSeed(), seedOf());
    }
}

// Every range up to 70000 takes part, and those around powers of two and at the ends of int.
TEST(Random, IntegersAreDebians) {
    const auto setSeed = debianOde::function(dRandSetSeed, "dRandSetSeed");
    const auto drawInt = debianOde::function(dRandInt, "dRandInt");
    std::vector<int> ranges{-1, -2, -70000, -0x7fffffff, -0x7fffffff - 1, 0x7fffffff, 0x7ffffffe, 1 << 30};
    for (int range = 0; range <= 70000; ++range) ranges.push_back(range);
    for (const std::uint32_t seed : kSeeds) {
        setSeed(seed);
        dRandSetSeed(seed);
        for (const int range : ranges) ASSERT_EQ(dRandInt(range), drawInt(range)) << "range " << range;
    }
    for (const int range : {2, 3, 4, 5, 16, 17, 255, 256, 257, 65535, 65536, 65537}) {
        for (int i = 0; i < 10000; ++i) ASSERT_EQ(dRandInt(range), drawInt(range)) << "range " << range;
    }
}

TEST(Random, RealsAreDebians) {
    if (!debianOde::kSamePrecision) GTEST_SKIP() << "another dReal";
    const auto setSeed = debianOde::function(dRandSetSeed, "dRandSetSeed");
    const auto drawReal = debianOde::function(dRandReal, "dRandReal");
    setSeed(99);
    dRandSetSeed(99);
    for (int i = 0; i < 100000; ++i) ASSERT_EQ(dRandReal(), drawReal());
    // The largest number drawn is 1, not below it.
    const std::uint32_t beforeLargest = dxRandom::jump(0xffffffff, (std::uint64_t{1} << 32) - 1);
    setSeed(beforeLargest);
    dRandSetSeed(beforeLargest);
    EXPECT_EQ(drawReal(), 1);
    EXPECT_EQ(dRandReal(), 1);
}

TEST(Random, SelfTestPassesAndLeavesTheSeed) {
    dRandSetSeed(4711);
    EXPECT_EQ(dTestRand(), debianOde::function(dTestRand, "dTestRand")());
    EXPECT_EQ(dRandGetSeed(), 4711u);
}

TEST(Random, BlocksOfManyThreadsAreDisjointAndConsecutive) {
    constexpr unsigned kThreads = 8, kBlocks = 2000;
    constexpr std::uint32_t kStart = 31;
    struct Block {
        std::uint32_t seed;
        std::uint64_t draws;
    };
    std::vector<std::vector<Block>> taken(kThreads);
    dxRandom::setSharedSeed(kStart);
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < kThreads; ++t) {
        threads.emplace_back([&own = taken[t], t] {
            for (unsigned i = 0; i < kBlocks; ++i) {
                const std::uint64_t draws = 1 + (i * 7 + t) % 50;
                own.push_back({dxRandom::takeSharedBlock(draws), draws});
            }
        });
    }
    for (std::thread &thread : threads) thread.join();

    // The blocks in the order of the sequence: each begins where the one before ends.
    std::vector<std::size_t> at(kThreads, 0);
    std::uint32_t seed = kStart;
    for (unsigned i = 0; i < kThreads * kBlocks; ++i) {
        unsigned t = 0;
        while (t < kThreads && (at[t] == kBlocks || taken[t][at[t]].seed != seed)) ++t;
        ASSERT_LT(t, kThreads) << "no block begins where block " << i << " has to";
        seed = dxRandom::jump(seed, taken[t][at[t]++].draws);
    }
    EXPECT_EQ(seed, dxRandom::sharedSeed());
}

TEST(Random, RewindsOnlyWhereNothingWasDrawnSince) {
    dxRandom::setSharedSeed(1);
    const std::uint32_t begin = dxRandom::takeSharedBlock(10);
    EXPECT_EQ(begin, 1u);
    const std::uint32_t end = dxRandom::jump(1, 10), middle = dxRandom::jump(1, 4);
    dxRandom::drawShared();
    EXPECT_FALSE(dxRandom::rewindShared(end, middle));
    EXPECT_EQ(dxRandom::sharedSeed(), dxRandom::next(end));
    dxRandom::setSharedSeed(end);
    EXPECT_TRUE(dxRandom::rewindShared(end, middle));
    EXPECT_EQ(dxRandom::sharedSeed(), middle);
}

}  // namespace
