// dxRegionIndex against brute force: members come, go and change between questions, whatever their boxes.
//
// Covers dxBoxBvh.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "collision/broadphase/dxRegionIndex.h"
#include "RandomBoxes.h"
#include "BroadphaseMembers.h"

namespace {

using Slot = BroadphaseMembers::Slot;

class RegionIndex : public testing::Test {
protected:
    void add(const dxBounds &box) { index.loosen(crowd.add(box), box); }
    void move(Slot slot, const dxBounds &box) {
        crowd.move(slot, box);
        index.loosen(slot, box);
    }
    void remove(Slot slot) {
        crowd.remove(slot);
        index.drop(slot);
    }
    void churn() {
        const Slot slot = random.below(300);
        if (!crowd.isThere(slot))
            add(random.box());
        else if (random.oneIn(3))
            remove(slot);
        else
            move(slot, random.box());
    }
    // Front of the list first.
    std::vector<Slot> expected(const dxBounds &box) const {
        std::vector<Slot> slots;
        for (Slot slot = 0; slot < crowd.members().end(); ++slot)
            if (crowd.isThere(slot) && crowd.members()[slot].bounds.overlaps(box)) slots.push_back(slot);
        std::sort(slots.begin(), slots.end(),
                  [&](Slot a, Slot b) { return crowd.members()[a].rank > crowd.members()[b].rank; });
        return slots;
    }
    std::vector<Slot> found(const dxBounds &box) {
        std::pmr::vector<Slot> slots;
        index.find(crowd.members(), box, slots);
        return {slots.begin(), slots.end()};
    }

    static dxBounds rayNumber(int ray) {
        return boundsOf(ray % 40, ray % 40 + ray % 7, ray / 3, ray / 3, 0, 0);
    }

    RandomBoxes random{11};
    BroadphaseMembers crowd;
    dxRegionIndex index;
};

TEST_F(RegionIndex, FindsNothingAmongNobody) {
    EXPECT_TRUE(found(cubeAt(0, 0, 0)).empty());
    add(cubeAt(0, 0, 0));
    remove(0);
    EXPECT_TRUE(found(cubeAt(0, 0, 0)).empty());
}

TEST_F(RegionIndex, FindsWhatOverlapsInTheOrderOfTheList) {
    for (int i = 0; i < 250; ++i) add(random.box());
    std::size_t overlaps = 0;
    for (int step = 0; step < 4000; ++step) {
        if (step % 400 < 100) churn();  // times of change, times of rest
        const dxBounds box = random.box();
        const std::vector<Slot> slots = found(box);
        ASSERT_EQ(slots, expected(box)) << "step " << step;
        overlaps += slots.size();
    }
    EXPECT_GT(overlaps, 10000u);
}

TEST_F(RegionIndex, ABoxWithoutEndFindsAllThatAreThereAndNobodyElse) {
    for (int i = 0; i < 67; ++i) add(cubeAt(i, 0, 0));
    for (int i = 0; i < 100; ++i) found(cubeAt(0, 0, 0));  // builds the tree
    remove(5);
    move(9, cubeAt(9, 1, 0));
    for (const dReal low : {-kInfinite, kNaN}) {
        const dxBounds everything = boundsOf(low, kInfinite, low, kInfinite, low, kInfinite);
        EXPECT_EQ(found(everything).size(), 66u);
        EXPECT_EQ(found(everything), expected(everything));
    }
}

TEST_F(RegionIndex, FindsASlotThatWasGivenAnewByItsNewBoxAlone) {
    for (int i = 0; i < 100; ++i) add(cubeAt(i, 0, 0, dReal(0.5)));
    for (int i = 0; i < 100; ++i) found(cubeAt(0, 0, 0));  // builds the tree
    remove(7);
    add(cubeAt(0, 50, 0));
    EXPECT_TRUE(found(cubeAt(7, 0, 0, dReal(0.1))).empty());
    EXPECT_EQ(found(cubeAt(0, 50, 0)).size(), 1u);
}

// Rays of several threads: one thread builds the tree, and all get the same results.
TEST_F(RegionIndex, SeveralThreadsAskWhileNothingChanges) {
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y) add(cubeAt(x, y, 0, dReal(0.9)));
    for (int round = 0; round < 20; ++round) {
        move(static_cast<Slot>(round * 7), cubeAt(round, 0, 0, dReal(0.9)));
        std::vector<std::vector<Slot>> wanted;
        for (int ray = 0; ray < 100; ++ray) wanted.push_back(expected(rayNumber(ray)));
        std::vector<std::thread> askers;
        std::atomic<int> wrong{0};
        for (int asker = 0; asker < 3; ++asker)
            askers.emplace_back([&] {
                for (int ray = 0; ray < 100; ++ray) wrong += found(rayNumber(ray)) != wanted[ray];
            });
        for (std::thread &asker : askers) asker.join();
        ASSERT_EQ(wrong, 0) << "round " << round;
    }
}

TEST_F(RegionIndex, AsksALineThroughACrowdOfThousands) {
    for (int x = 0; x < 60; ++x)
        for (int y = 0; y < 60; ++y) add(cubeAt(x, y, 0, dReal(0.9)));
    for (int i = 0; i < 200; ++i) {
        const dReal x = random.uniform(0, 59), y = random.uniform(0, 59), length = random.uniform(0, 6);
        const dxBounds ray = boundsOf(x, x + length, y, y, 0, 0);
        ASSERT_EQ(found(ray), expected(ray));
    }
}

}  // namespace
