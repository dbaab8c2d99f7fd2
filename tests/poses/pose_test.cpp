// Contacts of geoms of every two classes, in a million poses, are Debian's bit by bit.
//
// Has found: the sign of a zero depth, convex against mesh, where g++ had changed the order of fmax's
// arguments.
//
// Covers dxBoxContacts.cpp.
#include "two_libraries.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

using namespace exactness;

// Reads the pair from "convex mesh 16000 poses, ...".
std::string differenceOfPair(const std::string &line) {
    std::istringstream words(line);
    std::string one, other;
    words >> one >> other;
    const Lines command{ODE_MT_POSES_PROGRAM, one, other};
    const std::string difference =
        firstDifference(linesOn(Library::Debian, command), linesOn(Library::Ours, command));
    return difference.empty() ? "the difference does not repeat" : difference;
}

TEST(Poses, HaveDebiansContacts) {
    const Lines expected = linesOn(Library::Debian, {ODE_MT_POSES_PROGRAM}),
                actual = linesOn(Library::Ours, {ODE_MT_POSES_PROGRAM});
    ASSERT_GT(expected.size(), 60u);
    ASSERT_EQ(expected.size(), actual.size());
    ASSERT_NE(expected[0], actual[0]) << "both ran on one library";
    for (std::size_t i = 1; i < expected.size(); ++i) {
        EXPECT_EQ(expected[i], actual[i]) << differenceOfPair(expected[i]);
    }
}

// Else an equal hash would prove nothing.
TEST(Poses, AreRepeatableOnDebiansLibrary) {
    const Lines once = linesOn(Library::Debian, {ODE_MT_POSES_PROGRAM});
    EXPECT_EQ(once, linesOn(Library::Debian, {ODE_MT_POSES_PROGRAM}, "7"));
}

}  // namespace
