// Bad surroundings: ODE_MT gives the bits that libode8 gives in good ones, with one thread, with two, and
// with more than there are cores.
#include "support/child_run.h"
#include "two_libraries.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <tuple>

namespace {

using namespace exactness;

using Parameters = std::tuple<const char *, const char *>;  // surroundings, threads

class Surroundings : public testing::TestWithParam<Parameters> {};

TEST_P(Surroundings, GiveTheSameBits) {
    static const Lines expected = linesOn(Library::Debian, {ODE_MT_SURROUNDINGS_PROGRAM, "none"});
    const auto [name, threads] = GetParam();
    setenv("ODE_MT_THREADS", threads, 1);
    setenv("ODE_MT_ALGORITHM", "lcp", 1);
    const Lines actual = linesOn(Library::Ours, {ODE_MT_SURROUNDINGS_PROGRAM, name});
    ASSERT_NE(expected[0], actual[0]) << "both ran on one library";
    EXPECT_EQ(firstDifference(expected, actual), "");
}

std::string nameOf(const testing::TestParamInfo<Parameters> &info) {
    return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param) + "_threads";
}

INSTANTIATE_TEST_SUITE_P(All, Surroundings,
                         testing::Combine(testing::Values("none", "signals", "small_stack", "stack_limit", "address_space",
                                                          "no_threads", "busy_process", "many_threads",
                                                          "coming_and_going", "others_initialise"),
                                          testing::Values("0", "2", "16")),
                         nameOf);
// Once: it takes seconds to make a locale.
INSTANTIATE_TEST_SUITE_P(Locale, Surroundings,
                         testing::Combine(testing::Values("decimal_comma"), testing::Values("2")), nameOf);

// What the system refuses is reported.
TEST(SurroundingsReport, RefusedThreadsAreReportedOnce) {
    const char *const given = std::getenv("ODE_MT_LIBRARY_DIR");
    const support::Ending child = support::runProgram({ODE_MT_SURROUNDINGS_PROGRAM, "no_threads"},
                                                      {{"LD_LIBRARY_PATH", given != nullptr ? given : ODE_MT_OWN_LIBRARY_DIR},
                                                       {"ODE_MT_THREADS", "4"},
                                                       {"ODE_MT_ALGORITHM", "lcp"}});
    EXPECT_TRUE(child.exitedWith(0)) << child.text();
    const std::string text = "the system refused a thread";
    const std::size_t first = child.errors.find(text);
    EXPECT_NE(first, std::string::npos) << child.errors;
    EXPECT_EQ(child.errors.find(text, first + 1), std::string::npos) << child.errors;
}

}  // namespace
