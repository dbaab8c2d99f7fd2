// The skyline of a triangle, and whether its rows are finite, for every instruction set of this machine.
#include "dynamics/world_step/kernels/dxTriangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "instruction_sets.h"

TEST(Triangle, FindsTheFirstElementsAndWhatIsNotFinite) {
    using Limits = std::numeric_limits<dReal>;
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            for (unsigned n = 1; n < 40; ++n) {
                for (unsigned row = 0; row < n; ++row) {
                    const unsigned column = (7 * row + n) % (row + 1);
                    for (const dReal value : {dReal(1), dReal(-0.), Limits::denorm_min(), -Limits::infinity(), Limits::quiet_NaN()}) {
                        std::vector<dReal> triangle(std::size_t(n) * (n + 3), Limits::quiet_NaN());
                        for (unsigned i = 0; i < n; ++i)
                            std::fill_n(&triangle[i * std::size_t(n + 3)], i + 1, dReal(0));
                        triangle[row * std::size_t(n + 3) + column] = value;
                        EXPECT_EQ(dxAreRowsFinite(triangle.data(), 0, n, n + 3), std::isfinite(value));
                        std::vector<unsigned> begins(n);
                        dxFindSkyline(triangle.data(), n, n + 3, begins.data());
                        for (unsigned i = 0; i < n; ++i) EXPECT_EQ(begins[i], i == row ? column : i);
                    }
                }
            }
        });
    }
}

TEST(Triangle, SkylineOfSomeRowsIsThatOfTheFirstOfThem) {
    const unsigned begins[] = {0, 1, 0, 3, 4, 2, 5, 7};
    const dxSkyline skyline(begins), none;
    EXPECT_TRUE(skyline.skipsZeros());
    EXPECT_EQ(skyline.begin(3, 1), 3u);
    EXPECT_EQ(skyline.begin(3, 3), 2u);
    EXPECT_EQ(skyline.begin(6, 2, 4), 4u);
    EXPECT_FALSE(none.skipsZeros());
    EXPECT_EQ(none.begin(6, 2), 0u);
}
