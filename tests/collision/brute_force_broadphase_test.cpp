// What dxBruteForceBroadphase does beyond every search (broadphase_test.cpp).
#include <gtest/gtest.h>

#include "RandomBoxes.h"
#include "BroadphaseMembers.h"
#include "collision/broadphase/dxBruteForceBroadphase.h"

namespace {

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

}  // namespace
