// dxAdaptiveSearch: goes over to batches when many boxes travel, back when they rest, and misses nothing meanwhile.
#include <gtest/gtest.h>

#include <vector>

#include "RandomBoxes.h"
#include "SearchedMembers.h"
#include "collision/broadphase/dxAdaptiveSearch.h"

namespace {

class AdaptiveSearch : public testing::Test {
protected:
    AdaptiveSearch() {
        for (int i = 0; i < kBoxes; ++i)
            crowd.add(cubeAt(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8)));
    }

    void moveBy(SearchedMembers::Slot slot, dReal reach) {
        dxBounds box = crowd.members()[slot].bounds;
        const dReal way = random.uniform(-reach, reach);
        for (dReal &bound : box.v) bound += way;
        crowd.move(slot, box);
    }
    void travel() {
        for (SearchedMembers::Slot slot = 0; slot < kBoxes; ++slot) moveBy(slot, 2);
    }
    void stir() {
        for (int i = 0; i < 5; ++i) moveBy(random.below(kBoxes), 2);
    }
    void check() {
        const auto expected = crowd.expected();
        ASSERT_EQ(crowd.found(search), expected);
    }

    static constexpr int kBoxes = 400;
    RandomBoxes random{7};
    SearchedMembers crowd;
    dxAdaptiveSearch search;
};

TEST_F(AdaptiveSearch, FollowsWhatTheCrowdDoes) {
    for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 10; ++i) {
            travel();
            check();
        }
        EXPECT_EQ(search.current(), dxBroadPhase::NeighbourList);
        for (int i = 0; i < 20; ++i) {
            stir();
            check();
        }
        EXPECT_EQ(search.current(), dxBroadPhase::NeighbourSets);
    }
}

TEST_F(AdaptiveSearch, ABurstNowAndThenDoesNotMakeItGoBackAndForth) {
    for (int i = 0; i < 60; ++i) {
        if (i % 5 == 0)
            travel();
        else
            stir();
        check();
        EXPECT_EQ(search.current(), dxBroadPhase::NeighbourList);
    }
}

TEST(AdaptiveSearchOfFew, HasATableUntilThereAreMany) {
    RandomBoxes random(10);
    SearchedMembers crowd;
    dxAdaptiveSearch search;
    const auto somewhere = [&] { return cubeAt(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)); };
    std::vector<SearchedMembers::Slot> slots;
    for (int size = 0; size < 300; size += 10) {
        for (int i = 0; i < 10; ++i) slots.push_back(crowd.add(somewhere()));
        crowd.move(slots[random.below(static_cast<unsigned>(slots.size()))], somewhere());
        const auto expected = crowd.expected();
        ASSERT_EQ(crowd.found(search), expected) << slots.size();
        EXPECT_EQ(search.current() == dxBroadPhase::SlotTable, slots.size() <= 128) << slots.size();
    }
}

}  // namespace
