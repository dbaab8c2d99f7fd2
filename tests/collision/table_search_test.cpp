// dxTableSearch against brute force: members that come, go and change, few or many at once.
#include <gtest/gtest.h>

#include "RandomBoxes.h"
#include "SearchedMembers.h"
#include "collision/dxTableSearch.h"

namespace {

using Slot = SearchedMembers::Slot;

TEST(TableSearch, FindsNothingAmongNobodyAndAlone) {
    dxTableSearch search;
    SearchedMembers crowd;
    EXPECT_TRUE(crowd.found(search).empty());
    crowd.add(cubeAt(0, 0, 0));
    EXPECT_TRUE(crowd.found(search).empty());
}

// Three changes are looked up one by one, sixty together.
TEST(TableSearch, FindsEveryOverlapOnceWhateverTheBoxes) {
    for (const int changes : {3, 60}) {
        RandomBoxes random(8);
        std::size_t overlaps = 0;
        for (int round = 0; round < 40; ++round) {
            dxTableSearch search;
            SearchedMembers crowd;
            for (int step = 0; step < 12; ++step) {
                for (int i = 0; i < (step == 0 ? 60 : changes); ++i) {
                    const Slot slot = random.below(80);
                    if (!crowd.isThere(slot))
                        crowd.add(random.box());
                    else if (random.oneIn(5))
                        crowd.remove(slot);
                    else
                        crowd.move(slot, random.box());
                }
                const auto expected = crowd.expected();
                overlaps += expected.size();
                ASSERT_EQ(crowd.found(search), expected) << changes << " changes, round " << round << ", step " << step;
            }
        }
        EXPECT_GT(overlaps, 1500u);
    }
}

TEST(TableSearch, AdoptsMembersThatRest) {
    RandomBoxes random(9);
    SearchedMembers crowd;
    dxTableSearch first, second;
    for (int i = 0; i < 70; ++i) crowd.add(cubeAt(random.uniform(-3, 3), random.uniform(-3, 3), 0));
    crowd.remove(20);
    ASSERT_EQ(crowd.found(first), crowd.expected());
    second.adopt(crowd.members());
    crowd.move(5, cubeAt(0, 0, 0));
    const auto expected = crowd.expected();
    EXPECT_GT(expected.size(), 2u);
    EXPECT_EQ(crowd.found(second), expected);
}

}  // namespace
