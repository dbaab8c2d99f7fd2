// dxGridBroadphase against brute force, beyond what every broad phase has to do (broadphase_test.cpp): crowds and deserts.
//
// Covers dxCellGridPairs.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "RandomBoxes.h"
#include "BroadphaseMembers.h"
#include "collision/broadphase/dxGridBroadphase.h"

namespace {

// So many of each size that none is compared with all: boxes of one level are swept against those of others.
TEST(GridBroadphase, SweepsLargeAgainstSmall) {
    RandomBoxes random(4);
    dxGridBroadphase findOverlaps;
    BroadphaseMembers crowd;
    for (int i = 0; i < 1500; ++i) {
        const dReal edge = std::ldexp(dReal(0.3), i % 5);
        crowd.add(cubeAt(random.uniform(-12, 12), random.uniform(-12, 12), random.uniform(-3, 3), edge));
    }
    const auto expected = crowd.expected();
    EXPECT_GT(expected.size(), 3000u);
    EXPECT_EQ(crowd.found(findOverlaps), expected);
}

// It stops at the limit: soon after there are more pairs than are kept.
TEST(GridBroadphase, StopsAtThePairLimit) {
    BroadphaseMembers crowd;
    for (int i = 0; i < 3000; ++i) crowd.add(cubeAt(0, 0, 0));
    const std::size_t all = 3000 * 2999 / 2, most = dxMaxPairsOfWalk(3000);
    std::vector<dxBroadphase::Match> matches;
    dxGridBroadphase().findOverlaps(crowd.members(), dxTaskRunner::alone(), matches);
    EXPECT_EQ(matches.size(), all);
    matches.clear();
    dxGridBroadphase(dxMaxPairsOfWalk).findOverlaps(crowd.members(), dxTaskRunner::alone(), matches);
    EXPECT_GT(matches.size(), most);
    EXPECT_LT(matches.size(), most + all / 4);
}

// Boxes whose faces lie on borders of cells touch across them.
TEST(GridBroadphase, FindsBoxesThatTouch) {
    dxGridBroadphase findOverlaps;
    BroadphaseMembers crowd;
    for (int x = -4; x < 4; ++x)
        for (int y = -4; y < 4; ++y)
            for (int z = -4; z < 4; ++z) crowd.add(boundsOf(x, x + 1, y, y + 1, z, z + 1));
    const auto expected = crowd.expected();
    EXPECT_GT(expected.size(), 4000u);
    EXPECT_EQ(crowd.found(findOverlaps), expected);
}

// More cells than can be numbered, were they as small as the boxes.
TEST(GridBroadphase, FindsSmallBoxesFarApart) {
    RandomBoxes random(5);
    dxGridBroadphase findOverlaps;
    BroadphaseMembers crowd;
    for (int i = 0; i < 400; ++i) {
        const dReal x = random.uniform(-1, 1) * dReal(1e7), y = random.uniform(-1, 1) * dReal(1e7);
        crowd.add(cubeAt(x, y, 0, dReal(1e-3)));
        crowd.add(cubeAt(x, y, 0, dReal(2e-3)));
        crowd.add(boundsOf(x, x, y, y, 0, 0));
    }
    const auto expected = crowd.expected();
    EXPECT_GE(expected.size(), 1200u);
    EXPECT_EQ(crowd.found(findOverlaps), expected);
}

TEST(GridBroadphase, LeavesOutPairsThatRest) {
    dxGridBroadphase findOverlaps;
    BroadphaseMembers crowd;
    for (int i = 0; i < 100; ++i) crowd.add(cubeAt(dReal(i) / 2, 0, 0));
    EXPECT_GT(crowd.found(findOverlaps).size(), 99u);
    crowd.move(50, cubeAt(25, 0, 0));
    const auto expected = crowd.expected();
    EXPECT_EQ(expected.size(), 4u);
    EXPECT_EQ(crowd.found(findOverlaps), expected);
}

}  // namespace
