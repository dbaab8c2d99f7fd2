// Which values of two states differ, and how they are written.
#include "check/state_difference.h"

#include <gtest/gtest.h>

#include <cstring>

namespace check {

namespace {

std::uint64_t bits(double value) {
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof result);
    return result;
}

StoredState state(std::vector<std::uint64_t> bodies) {
    StoredState result{};
    result.world.bodies = bodies.size();
    for (const std::uint64_t number : bodies) {
        BodyState body{};
        body.number = number;
        result.bodies.push_back(body);
    }
    return result;
}

TEST(StateDifference, OfTheSameStatesIsNone) { EXPECT_FALSE(compareStates(state({0, 1}), state({0, 1}))); }

TEST(StateDifference, AllFieldsOfTheFirstBodyThatDiffersAreNamed) {
    const StoredState left = state({0, 4, 7});
    StoredState right = left;
    right.bodies[1].words[1] = bits(0.5);   // position y
    right.bodies[1].words[6] = bits(-0.0);  // quaternion z: the sign alone
    right.bodies[1].words[19] = 1;
    right.bodies[2].words[0] = bits(2);
    const auto difference = compareStates(left, right);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->differentBodies, 2u);
    EXPECT_EQ(difference->bodies, 3u);
    ASSERT_EQ(difference->values.size(), 3u);
    EXPECT_EQ(difference->values[0].body, 4u);
    EXPECT_EQ(difference->values[0].field, "position y");
    EXPECT_EQ(difference->values[0].left, "0 (0000000000000000)");
    EXPECT_EQ(difference->values[0].right, "0.5 (3fe0000000000000)");
    EXPECT_EQ(difference->values[1].field, "quaternion z");
    EXPECT_EQ(difference->values[1].right, "-0 (8000000000000000)");
    EXPECT_EQ(difference->values[2].field, "enabled flag");
    EXPECT_EQ(difference->values[2].right, "1");
}

// Every word belongs to a field.
TEST(StateDifference, AllWordsAreCompared) {
    const StoredState left = state({0});
    for (std::uint32_t word = 0; word < kBodyWords; ++word) {
        StoredState right = left;
        right.bodies[0].words[word] = 1;
        EXPECT_TRUE(compareStates(left, right)) << word;
    }
    for (std::uint32_t word = 0; word < kStepWords; ++word) {
        StoredState right = left;
        right.world.words[word] = 1;
        EXPECT_TRUE(compareStates(left, right)) << word;
    }
}

TEST(StateDifference, TheStepItselfIsPartOfIt) {
    const StoredState left = state({0});
    StoredState right = left;
    right.world.words[0] = bits(0.01);
    right.world.words[1] = kWorldQuickStep;
    const auto difference = compareStates(left, right);
    ASSERT_TRUE(difference);
    ASSERT_EQ(difference->values.size(), 2u);
    EXPECT_FALSE(difference->values[0].body);
    EXPECT_EQ(difference->values[0].field, "step size");
    EXPECT_EQ(difference->values[1].left, "dWorldStep");
    EXPECT_EQ(difference->values[1].right, "dWorldQuickStep");
}

TEST(StateDifference, BodiesThatOneSideAloneHasAreNamed) {
    const auto difference = compareStates(state({0, 1, 2}), state({0, 2}));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->values[0].field, "number of bodies");
    EXPECT_EQ(difference->values[0].left, "3");
    const auto other = compareStates(state({0, 2}), state({0, 3}));
    ASSERT_TRUE(other);
    EXPECT_EQ(other->values[0].body, 2u);
    EXPECT_EQ(other->values[0].right, "is not there");
}

}  // namespace

}  // namespace check
