// How the worlds of two runs are paired, and which difference is the first.
#include "check/first_difference.h"

#include <gtest/gtest.h>

namespace check {

namespace {

using Kind = FirstDifference::Kind;

WorldRecord world(WorldName name, std::vector<std::uint64_t> hashes, std::uint64_t firstStep = 1) {
    return {name, firstStep, std::move(hashes), 3};
}

RunRecord run(std::vector<WorldRecord> worlds) {
    RunRecord record;
    record.worlds = std::move(worlds);
    return record;
}

TEST(FirstDifference, RunsThatAreTheSameHaveNone) {
    const RunRecord a = run({world({0, 0}, {1, 2, 3}), world({1, 0}, {7})});
    const Comparison comparison = compareRuns(a, a, Ends::compared);
    EXPECT_FALSE(comparison.first);
    EXPECT_EQ(comparison.equalSteps, 4u);
    EXPECT_EQ(comparison.worlds, 2u);
    EXPECT_EQ(comparison.bodies, 6u);
}

TEST(FirstDifference, IsTheLowestStepOfAllWorlds) {
    const Comparison comparison = compareRuns(run({world({0, 0}, {1, 2, 3}), world({0, 1}, {5, 6, 7})}),
                                              run({world({0, 0}, {1, 2, 9}), world({0, 1}, {5, 8, 7})}), Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->kind, Kind::State);
    EXPECT_EQ(comparison.first->step, 2u);
    EXPECT_EQ(comparison.first->worlds.left->name.world, 1u);
    EXPECT_EQ(comparison.equalSteps, 3u);
}

TEST(FirstDifference, WorldsInAnotherOrderAreTheSame) {
    const RunRecord left = run({world({0, 0}, {1, 2}), world({0, 1}, {3, 4})}),
                    right = run({world({0, 0}, {3, 4}), world({0, 1}, {1, 2})});
    EXPECT_FALSE(compareRuns(left, right, Ends::compared).first);
}

// Worlds that one thread has made have their numbers in each run.
TEST(FirstDifference, WorldsOfOneThreadThatHaveExchangedEverythingDiffer) {
    RunRecord left = run({world({0, 0}, {1, 2}), world({0, 1}, {3, 4})}), right = run({world({0, 0}, {3, 4}), world({0, 1}, {1, 2})});
    for (WorldRecord &record : left.worlds) record.isNumbered = true;
    EXPECT_FALSE(compareRuns(left, right, Ends::compared).first);  // another thread has made one of the right run's
    for (WorldRecord &record : right.worlds) record.isNumbered = true;
    const Comparison comparison = compareRuns(left, right, Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->step, 1u);
    EXPECT_EQ(comparison.first->worlds.left->name.world, 0u);
    EXPECT_EQ(comparison.first->worlds.right->name.world, 0u);
    EXPECT_EQ(comparison.equalSteps, 0u);
    EXPECT_TRUE(areEqualInAnotherOrder(left, right, Ends::compared));
}

// An end is no exchange, and one world has none to exchange with.
TEST(FirstDifference, OtherEndsAreNoExchange) {
    const RunRecord left = run({world({0, 0}, {1, 2}), world({0, 1}, {3, 4})}), right = run({world({0, 0}, {1, 2}), world({0, 1}, {3})});
    EXPECT_FALSE(areEqualInAnotherOrder(left, right, Ends::compared));
    EXPECT_FALSE(areEqualInAnotherOrder(run({world({0, 0}, {1, 2})}), run({world({0, 0}, {5, 2}), world({0, 1}, {1})}), Ends::ignored));
}

TEST(FirstDifference, WorldsOfOneThreadMayBeInAnotherProcess) {
    RunRecord left = run({world({0, 0}, {1, 2}), world({1, 0}, {3, 4})}), right = run({world({0, 0}, {3, 4}), world({1, 0}, {1, 2})});
    for (RunRecord *const record : {&left, &right})
        for (WorldRecord &world : record->worlds) world.isNumbered = true;
    EXPECT_FALSE(compareRuns(left, right, Ends::compared).first);
}

// A pool's: tasks 1, 2 and 3 in the first process and 4 in the second one; in the other run it has the second task and so on.
TEST(FirstDifference, WorldsOfProcessesThatShareTasksMayHaveAnyNumber) {
    const auto numbered = [](RunRecord record) {
        for (WorldRecord &world : record.worlds) world.isNumbered = true;
        return record;
    };
    const RunRecord left = numbered(run({world({0, 0}, {1, 2}), world({0, 1}, {3, 4}), world({0, 2}, {5, 6}), world({1, 0}, {7, 8})})),
                    right = numbered(run({world({0, 0}, {1, 2}), world({0, 1}, {5, 6}), world({1, 0}, {3, 4}), world({1, 1}, {7, 8})})),
                    other = numbered(run({world({0, 0}, {1, 2}), world({0, 1}, {5, 60}), world({1, 0}, {3, 4}), world({1, 1}, {7, 8})})),
                    exchanged = numbered(run({world({0, 0}, {3, 4}), world({0, 1}, {1, 2}), world({0, 2}, {5, 6}), world({1, 0}, {7, 8})}));
    EXPECT_FALSE(compareRuns(left, right, Ends::compared).first);
    const Comparison comparison = compareRuns(left, other, Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->step, 2u);
    EXPECT_EQ(comparison.first->worlds.left->name.world, 2u);
    EXPECT_EQ(comparison.equalSteps, 7u);
    EXPECT_TRUE(compareRuns(left, exchanged, Ends::compared).first) << "within a process";
}

// The world of the same number, which begins alike, is another one's.
TEST(FirstDifference, WorldsThatAreTheSameArePairedFirst) {
    const RunRecord left = run({world({0, 0}, {1, 2, 3}), world({0, 1}, {1, 5})}),
                    right = run({world({0, 0}, {1, 5}), world({0, 1}, {1, 2, 3})});
    EXPECT_FALSE(compareRuns(left, right, Ends::compared).first);
}

TEST(FirstDifference, WorldsInAnotherOrderArePairedByWhatTheyShare) {
    const RunRecord left = run({world({0, 0}, {1, 2, 3}), world({0, 1}, {4, 5, 6})}),
                    right = run({world({0, 0}, {4, 5, 60}), world({0, 1}, {1, 20, 30})});
    const Comparison comparison = compareRuns(left, right, Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->step, 2u);
    EXPECT_EQ(comparison.first->worlds.left->name.world, 0u);
    EXPECT_EQ(comparison.first->worlds.right->name.world, 1u);
    EXPECT_EQ(comparison.equalSteps, 3u);
}

TEST(FirstDifference, OfTwoWorldsThatDoTheSameEachHasAPartner) {
    const RunRecord left = run({world({0, 0}, {1}), world({0, 1}, {1})}), right = run({world({0, 0}, {1}), world({0, 1}, {2})});
    const Comparison comparison = compareRuns(left, right, Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->worlds.left->name.world, 1u);
    EXPECT_EQ(comparison.first->worlds.right->name.world, 1u);
}

TEST(FirstDifference, AnEndIsOneUnlessItCameFromOutside) {
    const RunRecord left = run({world({0, 0}, {1, 2, 3})}), right = run({world({0, 0}, {1, 2})});
    const Comparison comparison = compareRuns(left, right, Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->kind, Kind::RightEnd);
    EXPECT_EQ(comparison.first->step, 3u);
    EXPECT_EQ(compareRuns(right, left, Ends::compared).first->kind, Kind::LeftEnd);
    EXPECT_FALSE(compareRuns(left, right, Ends::ignored).first);
}

TEST(FirstDifference, AWorldOfOneRunAloneIsOne) {
    const RunRecord left = run({world({0, 0}, {1})}), right = run({world({0, 0}, {1}), world({0, 1}, {2})});
    const Comparison comparison = compareRuns(left, right, Ends::compared);
    ASSERT_TRUE(comparison.first);
    EXPECT_EQ(comparison.first->worlds.left, nullptr);
    EXPECT_EQ(comparison.first->worlds.right->name.world, 1u);
    EXPECT_FALSE(compareRuns(left, right, Ends::ignored).first);
}

// In the child of a fork they begin behind those of its parent.
TEST(FirstDifference, StepsKeepTheirNumbersInAnotherProcess) {
    const RunRecord left = run({world({0, 0}, {1, 2}), world({1, 0}, {3, 4}, 3)}),
                    right = run({world({0, 0}, {1, 2}), world({1, 0}, {3, 5}, 3)});
    EXPECT_EQ(compareRuns(left, right, Ends::compared).first->step, 4u);
}

}  // namespace

}  // namespace check
