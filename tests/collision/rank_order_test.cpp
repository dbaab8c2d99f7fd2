// dxRankOrder against a sort of all members.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "RankedMembers.h"
#include "collision/pairs/dxRankOrder.h"

namespace {

std::vector<dxMembers::Slot> sorted(const dxMembers &members) {
    std::vector<dxMembers::Slot> slots;
    for (dxMembers::Slot slot = 0; slot < members.end(); ++slot)
        if (members.isPresent(slot)) slots.push_back(slot);
    std::sort(slots.begin(), slots.end(), [&](dxMembers::Slot a, dxMembers::Slot b) { return members[a].rank > members[b].rank; });
    return slots;
}

std::vector<dxMembers::Slot> slotsOf(const std::vector<dxSortItem> &items) {
    std::vector<dxMembers::Slot> slots;
    for (const dxSortItem &item : items) slots.push_back(item.index);
    return slots;
}

class RankOrder : public RankedMembers {
protected:
    dxRankOrder order;
};

TEST_F(RankOrder, OfNoMembersIsEmpty) { EXPECT_TRUE(order.update(members).empty()); }

TEST_F(RankOrder, IsThatOfASortAfterAnyChanges) {
    for (int count : {1, 7, 300}) {
        while (static_cast<int>(taken.size()) < count) add();
        for (int call = 0; call < 300; ++call) {
            const unsigned changes = random() % 3 == 0 ? random() % 200 : random() % 4;
            for (unsigned change = 0; change < changes && !taken.empty(); ++change) {
                switch (random() % 8) {
                case 0: add(); break;
                case 1: removeAny(); break;
                case 2: {
                    const dxMembers::Slot slot = any();
                    members.setPresence(slot, !members.isPresent(slot));
                    break;
                }
                default: members.setRank(any(), nextRank());
                }
            }
            ASSERT_EQ(slotsOf(order.update(members)), sorted(members)) << call << ", " << taken.size() << " members";
        }
    }
}

// Ranks may be given anew when there are no more.
TEST_F(RankOrder, IsThatOfASortWhenRanksOfOthersAreGivenAgain) {
    for (int i = 0; i < 20; ++i) add();
    order.update(members);
    std::vector<dxRank> given;
    for (const dxMembers::Slot slot : taken) given.push_back(members[slot].rank);
    std::shuffle(given.begin(), given.end(), random);
    for (std::size_t i = 0; i < taken.size(); ++i) members.setRank(taken[i], given[i]);
    EXPECT_EQ(slotsOf(order.update(members)), sorted(members));
}

}  // namespace
