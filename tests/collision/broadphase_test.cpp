// What every broad phase has to do, against brute force: members that come, go and change, few or many at once; sizes over
// many decades, boxes that no cell can hold.
#include <gtest/gtest.h>

#include "RandomBoxes.h"
#include "BroadphaseMembers.h"
#include "collision/broadphase/dxAdaptiveBroadphase.h"
#include "collision/broadphase/dxGridBroadphase.h"
#include "collision/broadphase/dxNeighbourBroadphase.h"
#include "collision/broadphase/dxBruteForce.h"
#include "collision/broadphase/dxVerletBroadphase.h"

namespace {

using Slot = BroadphaseMembers::Slot;

template <class>
class Broadphase : public testing::Test {};

using Broadphases = testing::Types<dxAdaptiveBroadphase, dxGridBroadphase, dxNeighbourBroadphase, dxBruteForceBroadphase, dxVerletBroadphase>;
TYPED_TEST_SUITE(Broadphase, Broadphases);

struct Churn {
    unsigned seed;
    int rounds, steps, changes;  // after the first step, which has 60
    std::size_t slots, minOverlaps;
};
constexpr Churn kChurns[] = {{3, 60, 6, 60, 200, 10000}, {8, 40, 12, 3, 80, 1500}, {8, 40, 12, 60, 80, 1500}};

void change(BroadphaseMembers &crowd, Slot slot, RandomBoxes &random) {
    if (!crowd.isThere(slot))
        crowd.add(random.box());
    else if (random.oneIn(5))
        crowd.remove(slot);
    else
        crowd.move(slot, random.box());
}

TYPED_TEST(Broadphase, FindsNothingWithoutMembersAndForOne) {
    TypeParam broadphase;
    BroadphaseMembers crowd;
    EXPECT_TRUE(crowd.found(broadphase).empty());
    crowd.add(cubeAt(0, 0, 0));
    EXPECT_TRUE(crowd.found(broadphase).empty());
}

TYPED_TEST(Broadphase, FindsEveryOverlapOnceWhateverTheBoxes) {
    for (const Churn &churn : kChurns) {
        RandomBoxes random(churn.seed);
        std::size_t overlaps = 0;
        for (int round = 0; round < churn.rounds; ++round) {
            TypeParam broadphase;
            BroadphaseMembers crowd;
            for (int step = 0; step < churn.steps; ++step) {
                for (int i = 0; i < (step == 0 ? 60 : churn.changes); ++i)
                    change(crowd, random.below(churn.slots), random);
                const auto expected = crowd.expected();
                overlaps += expected.size();
                ASSERT_EQ(crowd.found(broadphase), expected)
                    << churn.changes << " changes, round " << round << ", step " << step;
            }
        }
        EXPECT_GT(overlaps, churn.minOverlaps);
    }
}

}  // namespace
