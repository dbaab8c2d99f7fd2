// The version of the library and of its header, and how a program that also runs on upstream's library asks for ours.
//
// Covers api/common.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstdio>

namespace {

TEST(Version, OfTheLibraryIsThatOfItsHeader) { EXPECT_STREQ(dODE_MT_GetVersion(), dODE_MT_VERSION); }

TEST(Version, OfUpstreamIsTheReleaseThatTheBuildIsMadeOf) {
    EXPECT_STREQ(dODE_MT_GetUpstreamVersion(), UPSTREAM);
    EXPECT_STREQ(dODE_MT_GetUpstreamVersion(), dODE_VERSION) << "the header is of the same build";
}

TEST(Version, NumberIsThatOfTheText) {
    int first = 0, second = 0, third = 0;
    char rest = 0;
    ASSERT_EQ(std::sscanf(dODE_MT_VERSION, "%d.%d.%d%c", &first, &second, &third, &rest), 3);
    EXPECT_EQ(dODE_MT_VERSION_NUMBER, 10000 * first + 100 * second + third);
}

TEST(Version, IsAnExtensionOfOde) {
    EXPECT_EQ(dCheckConfiguration("ODE_EXT_mt"), 1);
    for (const char *none : {"ODE_EXT_m", "ODE_EXT_mt_", "ODE_EXT_mt_collisions", "ode_ext_mt"}) EXPECT_EQ(dCheckConfiguration(none), 0) << none;
    EXPECT_EQ(dCheckConfiguration("ODE_EXT_trimesh"), 1);
    EXPECT_EQ(dCheckConfiguration(""), 1);
}

}  // namespace
