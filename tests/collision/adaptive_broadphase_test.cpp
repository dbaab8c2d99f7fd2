// dxAdaptiveBroadphase: changes to a Verlet list when many boxes move, back when they rest, and misses nothing meanwhile.
#include <gtest/gtest.h>

#include <vector>

#include "RandomBoxes.h"
#include "BroadphaseMembers.h"
#include "collision/broadphase/dxAdaptiveBroadphase.h"

namespace {

class AdaptiveBroadphase : public testing::Test {
protected:
    AdaptiveBroadphase() {
        for (int i = 0; i < kBoxes; ++i)
            crowd.add(cubeAt(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8)));
    }

    void moveBy(BroadphaseMembers::Slot slot, dReal reach) {
        dxBounds box = crowd.members()[slot].bounds;
        const dReal way = random.uniform(-reach, reach);
        for (dReal &bound : box.v) bound += way;
        crowd.move(slot, box);
    }
    void travel() {
        for (BroadphaseMembers::Slot slot = 0; slot < kBoxes; ++slot) moveBy(slot, 2);
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
    BroadphaseMembers crowd;
    dxAdaptiveBroadphase search;
};

TEST_F(AdaptiveBroadphase, FollowsTheNumberOfMovingMembers) {
    for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 10; ++i) {
            travel();
            check();
        }
        EXPECT_EQ(search.current(), dxBroadphaseKind::VerletList);
        for (int i = 0; i < 20; ++i) {
            stir();
            check();
        }
        EXPECT_EQ(search.current(), dxBroadphaseKind::Neighbours);
    }
}

TEST_F(AdaptiveBroadphase, ABurstNowAndThenDoesNotMakeItGoBackAndForth) {
    for (int i = 0; i < 60; ++i) {
        if (i % 5 == 0)
            travel();
        else
            stir();
        check();
        EXPECT_EQ(search.current(), dxBroadphaseKind::VerletList);
    }
}

TEST(AdaptiveBroadphaseOfFew, IsBruteForceUntilThereAreMany) {
    RandomBoxes random(10);
    BroadphaseMembers crowd;
    dxAdaptiveBroadphase search;
    const auto somewhere = [&] { return cubeAt(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)); };
    std::vector<BroadphaseMembers::Slot> slots;
    for (int size = 0; size < 300; size += 10) {
        for (int i = 0; i < 10; ++i) slots.push_back(crowd.add(somewhere()));
        crowd.move(slots[random.below(static_cast<unsigned>(slots.size()))], somewhere());
        const auto expected = crowd.expected();
        ASSERT_EQ(crowd.found(search), expected) << slots.size();
        EXPECT_EQ(search.current() == dxBroadphaseKind::BruteForce, slots.size() <= 128) << slots.size();
    }
}

}  // namespace
