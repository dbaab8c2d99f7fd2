// dxDirtyQueue: each member once, in the order in which they came.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "collision/spaces/dxDirtyQueue.h"

namespace {

using Slot = dxDirtyQueue::Slot;

// Never looked into.
dxGeom *geom(std::uintptr_t number) { return reinterpret_cast<dxGeom *>(number * 64); }

TEST(DirtyQueue, KeepsTheFirstTurnOfEach) {
    dxDirtyQueue queue;
    for (const Slot slot : {4u, 2u, 4u, 9u, 2u}) queue.push(geom(slot), slot);
    EXPECT_EQ(queue.geoms(), (std::vector<dxGeom *>{geom(4), geom(2), geom(9)}));
    queue.clear();
    EXPECT_TRUE(queue.geoms().empty());
    queue.push(geom(2), 2);
    EXPECT_EQ(queue.geoms(), std::vector<dxGeom *>{geom(2)});
}

TEST(DirtyQueue, ASlotThatIsGivenAgainStandsAtItsNewPlace) {
    dxDirtyQueue queue;
    queue.push(geom(1), 1);
    queue.push(geom(5), 5);
    queue.drop(1);
    queue.drop(1);
    queue.drop(30);
    queue.push(geom(7), 1);
    EXPECT_EQ(queue.geoms(), (std::vector<dxGeom *>{geom(5), geom(7)}));
    queue.drop(5);
    queue.clear();
    queue.push(geom(7), 1);
    EXPECT_EQ(queue.geoms(), std::vector<dxGeom *>{geom(7)});
}

TEST(DirtyQueue, IsWhatAListWouldBe) {
    dxDirtyQueue queue;
    std::vector<Slot> list;
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        const Slot slot = random() % 40;
        const auto at = std::find(list.begin(), list.end(), slot);
        switch (random() % 8) {
        case 0:
            if (random() % 20 != 0) break;
            queue.clear();
            list.clear();
            break;
        case 1: case 2: case 3:
            queue.drop(slot);
            if (at != list.end()) list.erase(at);
            break;
        default:
            queue.push(geom(slot + 1), slot);
            if (at == list.end()) list.push_back(slot);
        }
        if (random() % 3 != 0) continue;
        std::vector<dxGeom *> expected;
        for (const Slot each : list) expected.push_back(geom(each + 1));
        ASSERT_EQ(queue.geoms(), expected);
    }
}

}  // namespace
