// dxMembers: slots, ranks and what has changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "bounds.h"
#include "collision/pairs/dxMembers.h"
#include "OdeSession.h"

namespace {

using Slot = dxMembers::Slot;

class Members : public testing::Test {
protected:
    ~Members() override { dGeomDestroy(geom); }

    // Processes the changes as a space does when it finds pairs.
    void seek() {
        for (const Slot slot : members.changed())
            if (members[slot].geom != nullptr) members.setBounds(slot, cubeAt(0, 0, 0));
        members.forgetChanges();
    }
    bool listedAsChanged(Slot slot) const {
        const auto &changed = members.changed();
        return std::count(changed.begin(), changed.end(), slot) == 1;
    }

    OdeSession session;
    dGeomID geom = dCreateSphere(nullptr, 1);
    dxMembers members;
};

TEST_F(Members, ANewMemberIsChangedAndHasNoRank) {
    const Slot slot = members.add(geom);
    EXPECT_EQ(members[slot].geom, geom);
    EXPECT_EQ(members[slot].rank, 0u);
    EXPECT_TRUE(members.isChanged(slot));
    EXPECT_TRUE(listedAsChanged(slot));
    EXPECT_EQ(members.unranked(), 1);
    members.setRank(slot, members.firstOf(1));
    EXPECT_EQ(members.unranked(), 0);
    members.setRank(slot, members.firstOf(1));
    EXPECT_EQ(members.unranked(), 0);
}

TEST_F(Members, AMemberIsListedOnceHoweverOftenItChanges) {
    const Slot slot = members.add(geom);
    members.markChanged(slot);
    members.markChanged(slot);
    EXPECT_TRUE(listedAsChanged(slot));
    seek();
    EXPECT_FALSE(members.isChanged(slot));
    EXPECT_TRUE(members.changed().empty());
    members.markChanged(slot);
    EXPECT_TRUE(listedAsChanged(slot));
}

// Its pairs go once; after that nothing that happens to it is a change, until it is back, with the rank it has by then.
TEST_F(Members, AnAbsentOneHasNoChanges) {
    const Slot slot = members.add(geom);
    members.setRank(slot, members.firstOf(1));
    seek();
    members.setPresence(slot, false);
    EXPECT_TRUE(listedAsChanged(slot));
    EXPECT_EQ(members[slot].geom, nullptr);
    EXPECT_EQ(members.geomIn(slot), geom);
    seek();
    const std::uint64_t orderings = members.orderings();
    const dxRank rank = members.firstOf(1);
    members.setRank(slot, rank);
    members.markChanged(slot);
    EXPECT_TRUE(members.changed().empty());
    EXPECT_EQ(members.orderings(), orderings);
    members.setPresence(slot, true);
    EXPECT_TRUE(listedAsChanged(slot));
    EXPECT_EQ(members[slot].geom, geom);
    EXPECT_EQ(members[slot].rank, rank);
    EXPECT_GT(members.orderings(), orderings);
}

TEST_F(Members, SwitchesAreListedOnceUntilTheyAreTakenIn) {
    const Slot slot = members.add(geom);
    members.noteSwitch(slot);
    members.noteSwitch(slot);
    EXPECT_EQ(members.switched(), std::vector<Slot>{slot});
    members.remove(slot);
    EXPECT_EQ(members.switched(), std::vector<Slot>{slot}) << "whoever has it by then";
    members.forgetSwitches();
    EXPECT_TRUE(members.switched().empty());
    EXPECT_EQ(members.add(geom), slot);
    members.noteSwitch(slot);
    EXPECT_EQ(members.switched(), std::vector<Slot>{slot});
}

TEST_F(Members, LaterRanksAreAboveEarlierOnes) {
    const dxRank first = members.firstOf(3);
    EXPECT_GE(first, 3u) << "three ranks down to 1";
    const dxRank second = members.firstOf(5);
    EXPECT_GT(second - 4, first);
}

// A kept pair still refers to the slot: it must be dropped, also if another member has the slot now.
TEST_F(Members, ASlotIsGivenAgainAtOnceAndCountsAsChanged) {
    const Slot slot = members.add(geom);
    members.setRank(slot, members.firstOf(1));
    seek();
    members.remove(slot);
    EXPECT_EQ(members[slot].geom, nullptr);
    EXPECT_TRUE(members.isChanged(slot));
    EXPECT_EQ(members.unranked(), 0);
    EXPECT_EQ(members.add(geom), slot);
    EXPECT_TRUE(listedAsChanged(slot));
    EXPECT_EQ(members[slot].rank, 0u);
    EXPECT_EQ(members.unranked(), 1);
}

// This holds also for a space that never finds pairs.
TEST_F(Members, ChurnNeedsNoMoreSlotsThanThereWereMembers) {
    for (int round = 0; round < 10000; ++round) {
        const Slot a = members.add(geom), b = members.add(geom);
        if (round == 1) seek();
        members.remove(a);
        members.remove(b);
    }
    EXPECT_LE(members.end(), 2u);
    EXPECT_LE(members.changed().size(), 2u);
}

}  // namespace
