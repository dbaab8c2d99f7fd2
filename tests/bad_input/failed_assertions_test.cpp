// Assertions that ODE_MT raises in upstream's place say what those of libode8 say, with file and line: people search for such messages.
#include "two_libraries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace exactness;

TEST(FailedAssertions, SayWhatThoseOfLibode8Say) {
    const Lines debian = linesOn(Library::Debian, {ODE_MT_FAILED_ASSERTIONS_PROGRAM}),
                ours = linesOn(Library::Ours, {ODE_MT_FAILED_ASSERTIONS_PROGRAM});
    ASSERT_EQ(debian.size(), ours.size());
    ASSERT_NE(debian[0], ours[0]) << "both ran on one library";
    for (std::size_t i = 1; i < debian.size(); ++i) EXPECT_EQ(debian[i], ours[i]);
    for (const char *text : {"cleaned", "aabbBound", "MinX", "MinZ", "g1->gflags", "g2->gflags", "collideGeomsNoAABBs"})
        EXPECT_TRUE(std::any_of(debian.begin(), debian.end(), [text](const std::string &line) { return line.find(text) != std::string::npos; }))
            << text;
}

}  // namespace
