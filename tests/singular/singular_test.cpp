// Where the exact step's matrix is singular, the solver says what Debian's does.
//
// Has found: of two NaNs that are added one is kept, and its sign decides whether "LCP internal error, s <=
// 0" is reported; with vectors in upstream's loops it was another one.
#include "two_libraries.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace exactness;

TEST(Singular, WorldsGiveDebiansMessages) {
    const Lines expected = linesOn(Library::Debian, {ODE_MT_SINGULAR_PROGRAM}),
                actual = linesOn(Library::Ours, {ODE_MT_SINGULAR_PROGRAM});
    ASSERT_EQ(expected.size(), actual.size());
    ASSERT_NE(expected[0], actual[0]) << "both ran on one library";
    EXPECT_EQ(firstDifference(expected, actual), "");

    const auto saysSo = [](const std::string &line) { return line.find("s=-inf") != std::string::npos; };
    EXPECT_GT(std::count_if(expected.begin(), expected.end(), saysSo), 100)
        << "the worlds are not singular enough";
}

TEST(Singular, WorldsAreRepeatableOnDebiansLibrary) {
    const Lines once = linesOn(Library::Debian, {ODE_MT_SINGULAR_PROGRAM});
    EXPECT_EQ(firstDifference(once, linesOn(Library::Debian, {ODE_MT_SINGULAR_PROGRAM}, "7")), "");
}

}  // namespace
