// The vectorised search for the maximum step gives the results of a scalar loop, for every instruction set of this machine.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "dynamics/world_step/kernels/dxMaximumStep.h"
#include "instruction_sets.h"

namespace {

constexpr dReal kInfinity = std::numeric_limits<dReal>::infinity();
constexpr unsigned kMax = 70;

// Room for whole vectors; what lies behind the last element is no number, and signals if it is used.
using Numbers = std::vector<dReal>;

class MaximumStep : public testing::Test {
protected:
    Numbers numbers(unsigned count) {
        Numbers made(kMax + 8, std::numeric_limits<dReal>::signaling_NaN());
        for (unsigned i = 0; i < count; ++i) made[i] = number();
        return made;
    }
    // One of few, so that there are zeros and equal ones.
    dReal number() { return dReal(static_cast<int>(random() % 9) - 4) / 2; }

    // Calls body(count) for every number of elements and instruction set; no exception flag may be raised.
    template <class Body>
    void forAll(const Body &body) {
        for (const std::int64_t set : instructionSets())
            onInstructionSet(set, [&] {
                for (unsigned count = 0; count <= kMax; ++count) {
                    std::feclearexcept(FE_ALL_EXCEPT);
                    body(count);
                    ASSERT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0) << count;
                }
            });
    }

    std::mt19937 random{7};
};

TEST_F(MaximumStep, FindsTheFirstThatReachesItsLimit) {
    unsigned founds = 0;
    forAll([&](unsigned end) {
        const Numbers x = numbers(end), delta = numbers(end);
        std::vector<dxLimitPair> limits(kMax + 8, {std::numeric_limits<dReal>::signaling_NaN(), kInfinity});
        for (unsigned i = 0; i < end; ++i) {
            const dReal high = std::fabs(number());
            limits[i] = {random() % 3 != 0 ? -high : -kInfinity, random() % 3 != 0 ? high : kInfinity};
        }
        const unsigned begin = end == 0 ? 0 : static_cast<unsigned>(random() % end);
        dReal expectedLength = random() % 4 != 0 ? dReal(3) : kInfinity, length = expectedLength;
        unsigned expected = end;
        for (unsigned i = begin; i < end; ++i) {
            if (delta[i] == 0) continue;
            const dReal own = ((delta[i] < 0 ? limits[i].low : limits[i].high) - x[i]) / delta[i];
            if (!(own < expectedLength)) continue;
            expectedLength = own;
            expected = i;
        }
        ASSERT_EQ(dxFindFirstAtLimit(x.data(), delta.data(), limits.data(), begin, end, length), expected)
            << begin << " to " << end;
        ASSERT_EQ(length, expectedLength);
        founds += expected != end;
    });
    EXPECT_GT(founds, kMax / 2);
}

TEST_F(MaximumStep, WhatIsNoNumberReachesNoLimit) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            Numbers x = numbers(8), delta(16, 1);
            std::vector<dxLimitPair> limits(16, {-9, 9});
            x[2] = std::numeric_limits<dReal>::quiet_NaN();
            delta[5] = std::numeric_limits<dReal>::quiet_NaN();
            x[6] = 8;  // the first of those that have a number
            dReal length = 5;
            EXPECT_EQ(dxFindFirstAtLimit(x.data(), delta.data(), limits.data(), 1, 8, length), 6u);
            EXPECT_EQ(length, 1);
        });
}

}  // namespace
