// dxChooseBroadPhase: each border between two broad phases, from either side, and what is remembered across it.
#include "collision/broadphase/dxBroadPhaseChoice.h"

#include <gtest/gtest.h>

#include <climits>

namespace {

using Threshold = dxBroadPhaseThresholds;

class BroadPhaseChoice : public testing::Test {
protected:
    // Of a space with so many geoms, all of them members.
    dxBroadPhase chooseFor(int geoms) {
        facts.geoms = geoms;
        facts.slots = static_cast<std::size_t>(geoms);
        return dxChooseBroadPhase(facts);
    }
    // As a space that grows or shrinks to so many geoms.
    dxBroadPhase follow(int geoms) { return facts.current = chooseFor(geoms); }

    dxBroadPhaseFacts facts;
};

TEST_F(BroadPhaseChoice, ASmallSimpleSpaceIsWalkedIfAnythingMoves) {
    facts.order = dxPairOrder::List;
    facts.mayWalk = true;
    facts.moved = 1;
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysWalked), dxBroadPhase::ListWalk);
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysWalked + 1), dxBroadPhase::OrderedTable);
    facts.moved = 0;
    EXPECT_EQ(chooseFor(Threshold::kMaxAlwaysWalked), dxBroadPhase::OrderedTable);
}

TEST_F(BroadPhaseChoice, AMiddlingSimpleSpaceIsWalkedIfThreeQuartersMove) {
    facts.order = dxPairOrder::List;
    facts.mayWalk = true;
    facts.moved = 75;
    EXPECT_EQ(chooseFor(100), dxBroadPhase::ListWalk);
    facts.moved = 74;
    EXPECT_EQ(chooseFor(100), dxBroadPhase::OrderedTable);
    facts.current = dxBroadPhase::ListWalk;
    EXPECT_EQ(chooseFor(100), dxBroadPhase::ListWalk) << "it is walked on";
    facts.moved = INT_MAX;
    EXPECT_EQ(chooseFor(Threshold::kMaxWalked), dxBroadPhase::ListWalk);
    EXPECT_NE(chooseFor(Threshold::kMaxWalked + 1), dxBroadPhase::ListWalk);
}

TEST_F(BroadPhaseChoice, AWalkEndsWhenHalfAsManyMove) {
    EXPECT_FALSE(dxHaveFewMoved(38, dxMinMovedToWalk(dxPairOrder::List, 100)));
    EXPECT_TRUE(dxHaveFewMoved(37, dxMinMovedToWalk(dxPairOrder::List, 100)));
    EXPECT_TRUE(dxHaveFewMoved(100, INT_MAX));
}

TEST_F(BroadPhaseChoice, NothingIsWalkedWhoseRanksAreNeededOrWhoseOrderIsAnother) {
    facts.moved = facts.geoms = 10;
    for (const dxPairOrder order : {dxPairOrder::List, dxPairOrder::Blocks, dxPairOrder::Axis, dxPairOrder::Cells}) {
        facts.order = order;
        facts.mayWalk = order != dxPairOrder::List;
        EXPECT_NE(dxChooseBroadPhase(facts), dxBroadPhase::ListWalk) << static_cast<int>(order);
    }
}

TEST_F(BroadPhaseChoice, TablesInOrderOfRanksGiveWayToSearchesAndComeBackAtHalfTheSize) {
    for (const dxPairOrder order : {dxPairOrder::List, dxPairOrder::Blocks}) {
        facts = {};
        facts.order = order;
        EXPECT_EQ(follow(256), dxBroadPhase::OrderedTable);
        EXPECT_EQ(follow(512), dxBroadPhase::OrderedTable);
        EXPECT_EQ(follow(513), dxBroadPhase::NeighbourList);
        EXPECT_EQ(follow(257), dxBroadPhase::NeighbourList);
        EXPECT_EQ(follow(256), dxBroadPhase::OrderedTable);
    }
}

TEST_F(BroadPhaseChoice, AnAxisIsSweptInSmallSpacesAndWhereItIsTheOnlyWay) {
    facts.order = dxPairOrder::Axis;
    EXPECT_EQ(follow(768), dxBroadPhase::AxisSap);
    EXPECT_EQ(follow(1024), dxBroadPhase::AxisSap);
    EXPECT_EQ(follow(1025), dxBroadPhase::NeighbourList);
    EXPECT_EQ(follow(769), dxBroadPhase::NeighbourList);
    EXPECT_EQ(follow(768), dxBroadPhase::AxisSap);
    facts.comparesAllAxes = false;
    EXPECT_EQ(follow(100000), dxBroadPhase::AxisSap);
}

TEST_F(BroadPhaseChoice, ATableOfSlotsGivesWayToAListAndComesBackAtHalfTheSize) {
    EXPECT_EQ(follow(128), dxBroadPhase::SlotTable);
    EXPECT_EQ(follow(129), dxBroadPhase::NeighbourList);
    EXPECT_EQ(follow(65), dxBroadPhase::NeighbourList);
    EXPECT_EQ(follow(64), dxBroadPhase::SlotTable);
    facts.current = dxBroadPhase::NeighbourSets;
    EXPECT_EQ(chooseFor(65), dxBroadPhase::NeighbourSets);
    EXPECT_EQ(chooseFor(64), dxBroadPhase::SlotTable);
}

TEST_F(BroadPhaseChoice, ListsAndNeighboursAreChangedAfterCallsThatSpeakAgainstThem) {
    facts.slots = 1000;
    facts.current = dxBroadPhase::NeighbourList;
    facts.callsAgainst = Threshold::kCallsAgainst - 1;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourList);
    facts.callsAgainst = Threshold::kCallsAgainst;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourSets);
    facts.current = dxBroadPhase::NeighbourSets;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourList);
    facts.callsAgainst = Threshold::kCallsAgainst - 1;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourSets);
}

TEST_F(BroadPhaseChoice, FewChangesSpeakAgainstAListAndManyAgainstNeighbours) {
    facts.slots = 1000;
    facts.current = dxBroadPhase::NeighbourList;
    facts.changed = 99;
    EXPECT_TRUE(dxSpeaksAgainst(facts));
    facts.changed = 100;
    EXPECT_FALSE(dxSpeaksAgainst(facts));
    facts.current = dxBroadPhase::NeighbourSets;
    facts.changed = 199;
    EXPECT_FALSE(dxSpeaksAgainst(facts));
    facts.changed = 200;
    EXPECT_TRUE(dxSpeaksAgainst(facts));
    facts.current = dxBroadPhase::SlotTable;
    EXPECT_FALSE(dxSpeaksAgainst(facts));
}

TEST_F(BroadPhaseChoice, MembersThatLeaveTheirNeighboursAllAtOnceAreListedAtOnce) {
    facts.current = dxBroadPhase::NeighbourSets;
    facts.slots = 1000;
    facts.lookedUp = 99;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourSets);
    facts.lookedUp = 100;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourList);
    facts.slots = 200;
    facts.lookedUp = Threshold::kMinLookUps - 1;
    EXPECT_EQ(dxChooseBroadPhase(facts), dxBroadPhase::NeighbourSets) << "a handful of look-ups takes no time";
}

TEST_F(BroadPhaseChoice, APairLimitIsNeverLowAndNeverBeyondMemory) {
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::List)(10), std::size_t{1} << 19);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Blocks)(8192), std::size_t{8192} * 8192 / 32);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Axis)(1000000), std::size_t{1} << 24);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Cells)(10), std::size_t{1} << 22);
    EXPECT_EQ(dxPairLimitOf(dxPairOrder::Cells)(1000000), std::size_t{1} << 22);
    EXPECT_EQ(dxUnlimitedPairs(3), SIZE_MAX);
}

}  // namespace
