// The lists of dxSapCleaner (dxSapLists): the order of members after geoms were added, changed and removed.
#include <gtest/gtest.h>

#include "collision/spaces/sweep_and_prune/dxSapCleaner.h"

namespace {

using Slots = std::vector<dxSapLists::Slot>;

Slots slotsOf(const std::vector<dxSapLists::Entry> &list) {
    Slots slots;
    for (const dxSapLists::Entry &entry : list) slots.push_back(entry.slot);
    return slots;
}

class SapLists : public testing::Test {
protected:
    SapLists() {
        for (dxSapLists::Slot slot = 0; slot < 5; ++slot) lists.add(slot, nullptr);
    }

    void expect(const Slots &dirty, const Slots &clean) {
        EXPECT_EQ(slotsOf(lists.dirty()), dirty);
        EXPECT_EQ(slotsOf(lists.clean()), clean);
        for (std::size_t i = 0; i < clean.size(); ++i) {
            EXPECT_EQ(lists.placeOf(clean[i]), i);
            EXPECT_FALSE(lists.isDirty(clean[i]));
        }
        for (const dxSapLists::Slot slot : dirty) EXPECT_TRUE(lists.isDirty(slot));
    }

    dxSapLists lists;
};

TEST_F(SapLists, WhatIsCleanedKeepsItsOrder) {
    expect({0, 1, 2, 3, 4}, {});
    lists.cleanAll();
    expect({}, {0, 1, 2, 3, 4});
}

TEST_F(SapLists, TheLastOneTakesTheFreePlace) {
    lists.remove(1);
    expect({0, 4, 2, 3}, {});
    lists.cleanAll();
    lists.remove(0);
    expect({}, {3, 4, 2});
    lists.remove(2);
    expect({}, {3, 4});
}

TEST_F(SapLists, WhatChangesStandsBehindWhatDidNot) {
    lists.cleanAll();
    lists.makeDirty(1);
    lists.makeDirty(4);
    expect({1, 4}, {0, 3, 2});
    lists.add(7, nullptr);
    lists.cleanAll();
    expect({}, {0, 3, 2, 1, 4, 7});
}

}  // namespace
