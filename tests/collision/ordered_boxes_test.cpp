// dxOrderedBoxes against a look at all members.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "RankedMembers.h"
#include "collision/broadphase/dxOrderedBoxes.h"

namespace {

class OrderedBoxes : public RankedMembers {
protected:
    dxBounds randomBox() {
        std::uniform_real_distribution<double> place(-10, 10), size(0, 6);
        dxBounds box;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = place(random);
            box.v[2 * axis] = static_cast<dReal>(low);
            box.v[2 * axis + 1] = static_cast<dReal>(low + size(random));
        }
        return box;
    }
    void addBox() {
        const Slot slot = add();
        members.setBounds(slot, randomBox());
    }

    std::vector<Slot> expected(const dxBounds &box) const {
        std::vector<Slot> slots;
        for (const Slot slot : taken)
            if (members.isPresent(slot) && members[slot].bounds.overlaps(box)) slots.push_back(slot);
        std::sort(slots.begin(), slots.end(), [&](Slot a, Slot b) { return members[a].rank > members[b].rank; });
        return slots;
    }
    void expectQuery() {
        const dxBounds box = randomBox();
        ASSERT_TRUE(boxes.find(members, box, false, found));
        ASSERT_EQ(std::vector<Slot>(found.slots, found.slots + found.count), expected(box));
    }

    dxOrderedBoxes boxes;
    dxOrderedBoxes::Found found;
};

TEST_F(OrderedBoxes, OfNoMembersFindNothing) { expectQuery(); }

// Queries of members that stay have columns in the end, and members that change take them away again.
TEST_F(OrderedBoxes, FindWhatOverlapsAfterAnyChanges) {
    int withColumns = 0, without = 0;
    for (const std::size_t count : {1, 7, 40, 500}) {
        while (taken.size() < count) addBox();
        for (int call = 0; call < 100; ++call) {
            for (std::uint64_t change = random() % 4; change > 0; --change) {
                switch (random() % 5) {
                case 0:
                    if (taken.size() < count) addBox();
                    break;
                case 1:
                    if (taken.size() > 1) removeAny();
                    break;
                case 2: members.setPresence(any(), random() % 2 == 0); break;
                case 3: members.setRank(any(), nextRank()); break;
                default: members.setBounds(any(), randomBox());
                }
            }
            for (std::uint64_t queries = random() % 6; queries > 0; --queries) {
                ASSERT_NO_FATAL_FAILURE(expectQuery()) << count << " members, call " << call;
                ++(boxes.hasColumns(members) ? withColumns : without);
            }
        }
    }
    EXPECT_GT(withColumns, 50);
    EXPECT_GT(without, 100);
}

TEST_F(OrderedBoxes, LeaveTheFirstQueriesToAFasterWay) {
    for (int i = 0; i < 100; ++i) addBox();
    for (int round = 0; round < 3; ++round) {
        int refused = 0;
        while (!boxes.find(members, randomBox(), true, found)) ASSERT_LT(++refused, 20);
        EXPECT_GT(refused, 0);
        EXPECT_TRUE(boxes.find(members, randomBox(), true, found)) << "while the members stay";
        members.setBounds(any(), randomBox());
        EXPECT_TRUE(boxes.find(members, randomBox(), true, found)) << "while few move";
        members.setRank(any(), nextRank());
    }
}

TEST_F(OrderedBoxes, OfTooManyMembersFindNothing) {
    while (taken.size() < dxOrderedBoxes::kMaxMembers) addBox();
    expectQuery();
    addBox();
    EXPECT_FALSE(boxes.find(members, randomBox(), false, found));
}

}  // namespace
