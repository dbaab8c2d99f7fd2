// A schedule of rows has the results of their order, and takes rows side by side that do not wait for one another; a shuffle is upstream's.
#include "dynamics/quick_step/sor/dxSorOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "dynamics/quick_step/sor/dxSorSweep.h"
#include "dynamics/step/random/dxRandom.h"
#include "random_sor_island.h"

namespace {

class SorOrder : public testing::TestWithParam<bool> {};  // with extreme numbers?

TEST_P(SorOrder, ByScheduleHasTheSameResult) {
    for (const Size size : kSizes) {
        RandomIsland ours(size.joints, size.bodies, 3 + size.joints, GetParam());
        RandomIsland reference(size.joints, size.bodies, 3 + size.joints, GetParam());
        reference.putFrictionLast();
        dxScheduleSor(ours.problem());
        ASSERT_TRUE(std::is_permutation(ours.scheduled.begin(), ours.scheduled.end(), reference.order.begin()));
        dxSorSweep(ours.problem(), ours.scheduled.data(), ours.problem().isLarge());
        sweepOneByOne(reference);
        EXPECT_TRUE(sameState(ours, reference)) << size.joints << " joints";
    }
}

INSTANTIATE_TEST_SUITE_P(Numbers, SorOrder, testing::Bool(),
                         [](const auto &info) { return info.param ? "extreme" : "ordinary"; });

// Ten bodies in a row, four rows between neighbours, in the order of the joints: a schedule takes rows of
// neighbours that share no body at once.
TEST(SorOrderOfRows, PutsRowsOfDifferentBodiesSideBySide) {
    constexpr unsigned kBodies = 10, kRowsPerLink = 4, kRows = (kBodies - 1) * kRowsPerLink;
    std::vector<dxConstraintRow> rows(kRows);
    std::vector<dxSpatialMotion> accelerations(kBodies);
    std::vector<int> scheduled(kRows);
    for (unsigned row = 0; row < kRows; ++row) {
        // Every second link first: the others wait for them, not for one another.
        const int link = static_cast<int>(row / kRowsPerLink * 2 % (kBodies - 1));
        rows[row].body[0] = link;
        rows[row].body[1] = link + 1;
        rows[row].boundingRow = dxConstraintRow::kNone;
    }
    dxScheduleSor({kRows, kBodies, rows.data(), nullptr, accelerations.data(), scheduled.data()});
    unsigned waiting = 0;
    for (unsigned i = 1; i < kRows; ++i) {
        const int *row = rows[scheduled[i]].body, *before = rows[scheduled[i - 1]].body;
        waiting += row[0] == before[0] || row[0] == before[1] || row[1] == before[0] || row[1] == before[1];
    }
    EXPECT_LE(waiting, 2 * kRowsPerLink);  // in the given order: 27 of 35
}

// Every entry but the first is swapped with one before it or itself, by one draw each of the shared sequence.
TEST(SorOrderOfRows, IsShuffledByTheSharedSequence) {
    constexpr unsigned kRows = 50;
    const std::uint32_t seed = dxRandom::sharedSeed();
    std::vector<int> order(kRows), expected(kRows);
    std::iota(order.begin(), order.end(), 0);
    std::iota(expected.begin(), expected.end(), 0);
    dxRandom::setSharedSeed(7);
    dxShuffleRows(order.data(), kRows);
    EXPECT_EQ(dxRandom::sharedSeed(), dxRandom::jump(7, kRows - 1));
    std::uint32_t drawn = 7;
    for (unsigned i = 1; i < kRows; ++i) {
        drawn = dxRandom::next(drawn);
        std::swap(expected[i], expected[static_cast<std::size_t>(dxRandom::toRange(drawn, i + 1))]);
    }
    EXPECT_EQ(order, expected);
    dxShuffleRows(order.data(), 1);
    EXPECT_EQ(dxRandom::sharedSeed(), dxRandom::jump(7, kRows - 1));
    dxRandom::setSharedSeed(seed);
}

}  // namespace
