// dxChooseBroadphase: each border between two broad phases, from either side, and what is remembered across it.
#include "collision/broadphase/dxBroadphaseChoice.h"

#include <gtest/gtest.h>

#include <climits>

namespace {

using Threshold = dxBroadphaseThresholds;

class BroadphaseChoice : public testing::Test {
protected:
    // Of a space with `geoms` geoms, all of them members.
    dxBroadphaseKind chooseFor(int geoms) {
        facts.geoms = geoms;
        facts.slots = static_cast<std::size_t>(geoms);
        return dxChooseBroadphase(facts);
    }
    // Of a space that grows or shrinks to `geoms` geoms.
    dxBroadphaseKind follow(int geoms) { return facts.current = chooseFor(geoms); }

    dxBroadphaseFacts facts;
};

TEST_F(BroadphaseChoice, ASmallSimpleSpaceIsWalkedIfAnythingMoves) {
    facts.order = dxPairOrder::List;
    facts.mayWalk = true;
    facts.moved = 1;
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysWalked), dxBroadphaseKind::ListWalk);
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysWalked + 1), dxBroadphaseKind::OrderedBruteForce);
    facts.moved = 0;
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysWalked), dxBroadphaseKind::OrderedBruteForce);
}

TEST_F(BroadphaseChoice, AMiddlingSimpleSpaceIsWalkedIfThreeQuartersMove) {
    facts.order = dxPairOrder::List;
    facts.mayWalk = true;
    facts.moved = 75;
    EXPECT_EQ(chooseFor(100), dxBroadphaseKind::ListWalk);
    facts.moved = 74;
    EXPECT_EQ(chooseFor(100), dxBroadphaseKind::OrderedBruteForce);
    facts.current = dxBroadphaseKind::ListWalk;
    EXPECT_EQ(chooseFor(100), dxBroadphaseKind::ListWalk) << "it is walked on";
    facts.moved = INT_MAX;
    EXPECT_EQ(chooseFor(Threshold::kMaxWalked), dxBroadphaseKind::ListWalk);
    EXPECT_NE(chooseFor(Threshold::kMaxWalked + 1), dxBroadphaseKind::ListWalk);
}

TEST_F(BroadphaseChoice, AWalkEndsWhenHalfAsManyMove) {
    EXPECT_FALSE(dxHaveFewMoved(38, dxMinMovedToWalk(dxPairOrder::List, 100)));
    EXPECT_TRUE(dxHaveFewMoved(37, dxMinMovedToWalk(dxPairOrder::List, 100)));
    EXPECT_TRUE(dxHaveFewMoved(100, INT_MAX));
}

TEST_F(BroadphaseChoice, ASweepAndPruneSpaceIsWalkedWhereExtentsMeetFewOthers) {
    facts.order = dxPairOrder::Axis;
    facts.mayWalk = true;
    facts.moved = 1;
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysSwept), dxBroadphaseKind::ListWalk);
    EXPECT_NE(chooseFor(1000), dxBroadphaseKind::ListWalk);
    facts.moved = 125;
    EXPECT_EQ(chooseFor(1000), dxBroadphaseKind::ListWalk);
    facts.comparisons = Threshold::kMaxComparisonsWalked * 1000 + 1;
    EXPECT_NE(chooseFor(1000), dxBroadphaseKind::ListWalk);
    facts.current = dxBroadphaseKind::ListWalk;
    EXPECT_EQ(chooseFor(1000), dxBroadphaseKind::ListWalk) << "it is walked on";
    facts.comparisons *= 2;
    EXPECT_NE(chooseFor(1000), dxBroadphaseKind::ListWalk);
}

TEST_F(BroadphaseChoice, NothingIsWalkedWhoseRanksAreNeededOrWhoseOrderIsAnother) {
    facts.moved = facts.geoms = 10;
    for (const dxPairOrder order : {dxPairOrder::List, dxPairOrder::Blocks, dxPairOrder::Axis, dxPairOrder::Cells}) {
        facts.order = order;
        facts.mayWalk = order == dxPairOrder::Blocks || order == dxPairOrder::Cells;
        EXPECT_NE(dxChooseBroadphase(facts), dxBroadphaseKind::ListWalk) << static_cast<int>(order);
    }
}

TEST_F(BroadphaseChoice, OrderedBruteForceGivesWayToAVerletListAndComesBackAtHalfTheSize) {
    for (const dxPairOrder order : {dxPairOrder::List, dxPairOrder::Blocks}) {
        facts = {};
        facts.order = order;
        EXPECT_EQ(follow(256), dxBroadphaseKind::OrderedBruteForce);
        EXPECT_EQ(follow(512), dxBroadphaseKind::OrderedBruteForce);
        EXPECT_EQ(follow(513), dxBroadphaseKind::VerletList);
        EXPECT_EQ(follow(257), dxBroadphaseKind::VerletList);
        EXPECT_EQ(follow(256), dxBroadphaseKind::OrderedBruteForce);
    }
}

TEST_F(BroadphaseChoice, BruteForceGivesWayToAVerletListAndComesBackAtHalfTheSize) {
    EXPECT_EQ(follow(128), dxBroadphaseKind::BruteForce);
    EXPECT_EQ(follow(129), dxBroadphaseKind::VerletList);
    EXPECT_EQ(follow(65), dxBroadphaseKind::VerletList);
    EXPECT_EQ(follow(64), dxBroadphaseKind::BruteForce);
    facts.current = dxBroadphaseKind::Neighbours;
    EXPECT_EQ(chooseFor(65), dxBroadphaseKind::Neighbours);
    EXPECT_EQ(chooseFor(64), dxBroadphaseKind::BruteForce);
}

TEST_F(BroadphaseChoice, ListsAndNeighboursAreChangedAfterCallsThatSpeakAgainstThem) {
    facts.slots = 1000;
    facts.current = dxBroadphaseKind::VerletList;
    facts.mismatchStreak = Threshold::kMinMismatchStreak - 1;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::VerletList);
    facts.mismatchStreak = Threshold::kMinMismatchStreak;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::Neighbours);
    facts.current = dxBroadphaseKind::Neighbours;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::VerletList);
    facts.mismatchStreak = Threshold::kMinMismatchStreak - 1;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::Neighbours);
}

TEST_F(BroadphaseChoice, FewChangesSpeakAgainstAListAndManyAgainstNeighbours) {
    facts.slots = 1000;
    facts.current = dxBroadphaseKind::VerletList;
    facts.changed = 99;
    EXPECT_TRUE(dxPrefersOtherBroadphase(facts));
    facts.changed = 100;
    EXPECT_FALSE(dxPrefersOtherBroadphase(facts));
    facts.current = dxBroadphaseKind::Neighbours;
    facts.changed = 199;
    EXPECT_FALSE(dxPrefersOtherBroadphase(facts));
    facts.changed = 200;
    EXPECT_TRUE(dxPrefersOtherBroadphase(facts));
    facts.current = dxBroadphaseKind::BruteForce;
    EXPECT_FALSE(dxPrefersOtherBroadphase(facts));
}

TEST_F(BroadphaseChoice, MembersThatLeaveTheirNeighboursAllAtOnceAreListedAtOnce) {
    facts.current = dxBroadphaseKind::Neighbours;
    facts.slots = 1000;
    facts.lookedUp = 99;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::Neighbours);
    facts.lookedUp = 100;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::VerletList);
    facts.slots = 200;
    facts.lookedUp = Threshold::kMinLookUps - 1;
    EXPECT_EQ(dxChooseBroadphase(facts), dxBroadphaseKind::Neighbours) << "a handful of look-ups takes no time";
}

TEST_F(BroadphaseChoice, APairLimitIsNeverLowAndNeverBeyondMemory) {
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::List)(10), std::size_t{1} << 19);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Blocks)(8192), std::size_t{8192} * 8192 / 32);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Axis)(1000000), std::size_t{1} << 24);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Cells)(10), std::size_t{1} << 22);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Cells)(1000000), std::size_t{1} << 22);
    EXPECT_EQ(dxUnlimitedPairs(3), SIZE_MAX);
}

}  // namespace
