// dxPairKeeping: the way with the lower cost is taken in the end, and changed no more often than pays.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "collision/broadphase/dxPairKeeping.h"

namespace {

dxPairWork work(std::size_t geoms, std::size_t changed, std::size_t overlaps) {
    dxPairWork work;
    work.geoms = geoms;
    work.changed = changed;
    work.comparisons = geoms * geoms / 2;
    work.overlaps = work.pairs = overlaps;
    const double rest = 1 - static_cast<double>(changed) / static_cast<double>(geoms);
    work.found = static_cast<std::size_t>((1 - rest * rest) * static_cast<double>(overlaps));
    return work;
}

constexpr dxPairOrder kOrders[] = {dxPairOrder::List, dxPairOrder::Blocks, dxPairOrder::Axis, dxPairOrder::Cells};

TEST(PairKeeping, PairsOfGeomsAtRestAreKept) {
    for (const dxPairOrder order : kOrders) {
        dxPairKeeping keeping(order);
        keeping.note(work(1000, 1000, 5000));  // all are new
        for (int call = 0; call < 100; ++call) keeping.note(work(1000, 0, 5000));
        EXPECT_TRUE(keeping.isKept()) << static_cast<int>(order);
    }
}

TEST(PairKeeping, OfACrowdInWhichMostMoveNoneIsKept) {
    for (const dxPairOrder order : kOrders) {
        dxPairKeeping keeping(order);
        for (int call = 0; call < 20; ++call) keeping.note(work(800, 700, 300000));
        EXPECT_FALSE(keeping.isKept()) << static_cast<int>(order);
        for (int call = 0; call < 1000 && !keeping.isKept(); ++call) keeping.note(work(800, 0, 5000));
        EXPECT_TRUE(keeping.isKept()) << "they have parted, and rest";
    }
}

TEST(PairKeeping, OfALargeSparseSpaceTheyAreKept) {
    for (const dxPairOrder order : {dxPairOrder::List, dxPairOrder::Blocks, dxPairOrder::Cells}) {
        dxPairKeeping keeping(order);
        for (int call = 0; call < 100; ++call) keeping.note(work(20000, 20000, 50000));
        EXPECT_TRUE(keeping.isKept()) << static_cast<int>(order);
    }
}

TEST(PairKeeping, OfAFewInAQuadTreeTheyAreKeptAfterSomeCallsAtRest) {
    constexpr auto kFew = static_cast<std::size_t>(dxBroadphaseThresholds::kMaxAlwaysWalked);
    dxPairKeeping keeping(dxPairOrder::Blocks);
    keeping.note(work(kFew, 1, kFew));
    EXPECT_FALSE(keeping.isKept());
    for (int call = 1; call < dxBroadphaseThresholds::kMinCallsRested; ++call) keeping.note(work(kFew, 0, kFew));
    EXPECT_FALSE(keeping.isKept());
    keeping.note(work(kFew, 0, kFew));
    EXPECT_TRUE(keeping.isKept());
    keeping.note(work(kFew, 1, kFew));
    EXPECT_FALSE(keeping.isKept());
}

TEST(PairKeeping, BeyondTheLimitNoneIsKeptUntilThereAreHalfAsMany) {
    dxPairKeeping keeping(dxPairOrder::Cells);
    keeping.overflow();
    EXPECT_FALSE(keeping.isKept());
    const std::size_t limit = dxPairLimitOf(dxPairOrder::Cells)(100000);
    for (int call = 0; call < 1000; ++call) keeping.note(work(100000, 0, limit / 2 + 1));
    EXPECT_FALSE(keeping.isKept());
    for (int call = 0; call < 1000 && !keeping.isKept(); ++call) keeping.note(work(100000, 0, limit / 2));
    EXPECT_TRUE(keeping.isKept());
}

TEST(PairKeeping, WhatTheClockSaysCorrectsTheEstimate) {
    const dxPairWork moving = work(1000, 1000, 5000);
    dxPairKeeping estimated(dxPairOrder::Blocks), measured(dxPairOrder::Blocks);
    for (int call = 0; call < 100; ++call) {
        estimated.note(moving);
        measured.noteTime(moving, 10 * dxCostOfKeeping(dxPairOrder::Blocks, moving));
        measured.note(moving);
    }
    EXPECT_TRUE(estimated.isKept());
    EXPECT_FALSE(measured.isKept());
}

// The claim of dxPairKeeping.h, for any calls: at most a few times the cheaper way.
TEST(PairKeeping, CostsAtMostAFewTimesTheCheaperWay) {
    std::mt19937 random(1);
    for (const dxPairOrder order : kOrders)
        for (int run = 0; run < 200; ++run) {
            dxPairKeeping keeping(order);
            double taken = 0, kept = 0, anew = 0;
            std::size_t moved = 0, overlaps = 0;
            const std::size_t geoms = 20 + random() % 2000;
            for (int call = 0; call < 400; ++call) {
                if (random() % 20 == 0) {
                    moved = random() % 2 == 0 ? 0 : random() % geoms;
                    overlaps = random() % (1 + geoms * std::min<std::size_t>(geoms / 2, 1 + random() % geoms));
                }
                dxPairWork now = work(geoms, moved, overlaps);
                const bool wasKept = keeping.isKept();
                kept += dxCostOfKeeping(order, now);
                anew += dxCostOfFindingAnew(order, now);
                taken += wasKept ? dxCostOfKeeping(order, now) : dxCostOfFindingAnew(order, now);
                keeping.note(now);
                if (!wasKept && keeping.isKept()) taken += dxCostOfKeeping(order, work(geoms, geoms, overlaps));
            }
            const double firstCalls = 20 * dxCostOfFindingAnew(order, work(geoms, geoms, geoms * geoms / 2));
            ASSERT_LT(taken, 5 * std::min(kept, anew) + firstCalls) << static_cast<int>(order) << " " << run;
        }
}

}  // namespace
