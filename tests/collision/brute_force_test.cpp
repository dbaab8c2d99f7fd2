// What dxBruteForceBroadphase does beyond every broad phase (broadphase_test.cpp), and dxBruteForcePairs: the pairs of a small space, in the order
// of ranks, kept up to date, against a plain comparison of every two boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "BroadphaseMembers.h"
#include "OdeSession.h"
#include "RandomBoxes.h"
#include "collision/broadphase/dxBruteForce.h"

namespace {

using Slot = dxMembers::Slot;

TEST(BruteForceBroadphase, AdoptsMembersThatRest) {
    RandomBoxes random(9);
    BroadphaseMembers crowd;
    dxBruteForceBroadphase first, second;
    for (int i = 0; i < 70; ++i) crowd.add(cubeAt(random.uniform(-3, 3), random.uniform(-3, 3), 0));
    crowd.remove(20);
    const auto expectedFirst = crowd.expected();
    ASSERT_EQ(crowd.found(first), expectedFirst);
    second.adopt(crowd.members());
    crowd.move(5, cubeAt(0, 0, 0));
    const auto expected = crowd.expected();
    EXPECT_GT(expected.size(), 2u);
    EXPECT_EQ(crowd.found(second), expected);
}

class BruteForcePairs : public testing::Test {
protected:
    ~BruteForcePairs() override {
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members[slot].geom != nullptr) dGeomDestroy(members[slot].geom);
        dWorldDestroy(world);
    }

    dxPairFilter filterOf(Slot slot) const {
        const dGeomID geom = members[slot].geom;
        return {dGeomGetBody(geom), dGeomGetCategoryBits(geom), dGeomGetCollideBits(geom)};
    }
    void toFront(Slot slot) {
        members.setRank(slot, members.firstOf(1));
        members.setBounds(slot, random.box(), filterOf(slot));
        members.markChanged(slot);
    }
    void add() {
        const dGeomID geom = dCreateSphere(nullptr, 1);
        if (random.oneIn(2)) dGeomSetBody(geom, random.oneIn(3) ? shared : dBodyCreate(world));
        toFront(members.add(geom));
    }
    void remove(Slot slot) {
        dGeomDestroy(members[slot].geom);
        members.remove(slot);
    }
    // Moves nothing: the member keeps its place in the list.
    void setBits(Slot slot) {
        dGeomSetCategoryBits(members[slot].geom, 1u << random.below(3));
        dGeomSetCollideBits(members[slot].geom, 1u << random.below(3));
        members.setBounds(slot, members[slot].bounds, filterOf(slot));
        members.markChanged(slot);
    }
    // The member keeps its rank, as in a quad tree.
    void moveInPlace(Slot slot) {
        members.setBounds(slot, random.box(), filterOf(slot));
        members.markChanged(slot);
    }
    void changeSome() {
        if (random.oneIn(3)) {
            const std::uint32_t share = 1 + random.below(8);
            for (Slot slot = 0; slot < members.end(); ++slot)
                if (members[slot].geom != nullptr && random.oneIn(share)) moveInPlace(slot);
        }
        if (random.oneIn(3)) return;
        for (std::uint32_t i = random.below(8); i > 0; --i) {
            const Slot slot = random.below(members.end());
            if (members[slot].geom == nullptr || random.oneIn(6)) add();
            else if (random.oneIn(6)) remove(slot);
            else if (random.oneIn(4)) setBits(slot);
            else toFront(slot);
        }
    }

    std::vector<std::pair<Slot, Slot>> update() {
        dense.update(members, pairs);
        members.forgetChanges();
        std::vector<std::pair<Slot, Slot>> found;
        for (const dxOrderedPair &pair : pairs) {
            EXPECT_EQ(pair.first, members[pair.slots[0]].geom);
            EXPECT_EQ(pair.second, members[pair.slots[1]].geom);
            found.emplace_back(pair.slots[0], pair.slots[1]);
        }
        return found;
    }
    std::vector<std::pair<Slot, Slot>> bruteForce() const {
        std::vector<Slot> list;
        for (Slot slot = 0; slot < members.end(); ++slot)
            if (members[slot].geom != nullptr) list.push_back(slot);
        std::sort(list.begin(), list.end(), [&](Slot a, Slot b) { return members[a].rank > members[b].rank; });
        std::vector<std::pair<Slot, Slot>> expected;
        for (std::size_t i = 0; i < list.size(); ++i)
            for (std::size_t k = i + 1; k < list.size(); ++k)
                if (members[list[i]].bounds.overlaps(members[list[k]].bounds) && mayMeet(list[i], list[k]))
                    expected.emplace_back(list[i], list[k]);
        return expected;
    }
    bool mayMeet(Slot a, Slot b) const {
        const dGeomID one = members[a].geom, two = members[b].geom;
        if (dGeomGetBody(one) != nullptr && dGeomGetBody(one) == dGeomGetBody(two)) return false;
        return (dGeomGetCategoryBits(one) & dGeomGetCollideBits(two)) != 0 ||
               (dGeomGetCategoryBits(two) & dGeomGetCollideBits(one)) != 0;
    }

    OdeSession session;
    dWorldID world = dWorldCreate();
    dBodyID shared = dBodyCreate(world);
    RandomBoxes random{6};
    dxMembers members;
    dxBruteForcePairs dense;
    std::vector<dxOrderedPair> pairs;
};

TEST_F(BruteForcePairs, AreThoseOfBruteForceInOrder) {
    for (int i = 0; i < 60; ++i) add();
    std::size_t found = 0;
    for (int frame = 0; frame < 2000; ++frame) {
        const auto now = update();
        ASSERT_EQ(now, bruteForce()) << "frame " << frame;
        found += now.size();
        changeSome();
    }
    EXPECT_GT(found, 100000u);
}

// Models robots among resting objects: those in front exchange their places, and occasionally another one moves.
TEST_F(BruteForcePairs, MembersInFrontExchangePlaces) {
    for (int i = 0; i < 40; ++i) add();
    std::vector<Slot> robots = {3, 17, 21, 30, 31};
    for (int frame = 0; frame < 600; ++frame) {
        std::rotate(robots.begin(), robots.begin() + 1 + random.below(4), robots.end());
        for (const Slot robot : robots) toFront(robot);
        if (random.oneIn(20)) toFront(random.below(40));
        if (random.oneIn(20)) setBits(random.below(40));
        if (random.oneIn(40)) add();
        ASSERT_EQ(update(), bruteForce()) << "frame " << frame;
    }
}

// A space that begins to keep its pairs again: free slots count as changed, and no rank has changed.
TEST_F(BruteForcePairs, AreFoundAmongFreeSlots) {
    for (int i = 0; i < 40; ++i) add();
    for (int frame = 0; frame < 20; ++frame) {
        remove(static_cast<Slot>(2 * frame));
        update();
        pairs.clear();
        members.markAllChanged();
        ASSERT_EQ(update(), bruteForce()) << "frame " << frame;
    }
}

TEST_F(BruteForcePairs, AreNoneOnceAllMembersAreRemoved) {
    for (int i = 0; i < 20; ++i) add();
    update();
    for (Slot slot = 0; slot < members.end(); ++slot) remove(slot);
    EXPECT_TRUE(update().empty());
    add();
    EXPECT_EQ(update(), bruteForce());
}

}  // namespace
