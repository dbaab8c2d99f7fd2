// Subnormal numbers are 0 as long as they are flushed, and only then; the thread's traps and rounding stay.
#include <gtest/gtest.h>

#include <cfenv>
#include <limits>

#include <hwy/highway.h>

#include "core/dxFlushSubnormals.h"

namespace {

volatile float tiny = std::numeric_limits<float>::min() / 4, one = 1, third = 3;

// Calls that are not inlined keep their place beside those that change the environment.
[[gnu::noinline]] float product() { return tiny * one; }
[[gnu::noinline]] float quotient() { return one / third; }

TEST(FlushSubnormals, EndsWithItsScope) {
    EXPECT_GT(product(), 0);
    {
        const dxFlushSubnormals flush;
        if (HWY_ARCH_X86) EXPECT_EQ(product(), 0);
        {
            const dxFlushSubnormals inner;
        }
        if (HWY_ARCH_X86) EXPECT_EQ(product(), 0) << "as before the inner scope";
    }
    EXPECT_GT(product(), 0);
}

TEST(FlushSubnormals, KeepsRoundingAndTraps) {
    const int before = std::fegetround();
    std::fesetround(FE_DOWNWARD);
    const float down = quotient();
    feenableexcept(FE_DIVBYZERO);
    {
        const dxFlushSubnormals flush;
        EXPECT_EQ(quotient(), down);
        EXPECT_EQ(fegetexcept(), FE_DIVBYZERO);
    }
    EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
    EXPECT_EQ(fegetexcept(), FE_DIVBYZERO);
    fedisableexcept(FE_DIVBYZERO);
    std::fesetround(before);
    EXPECT_GT(quotient(), down);
}

}  // namespace
