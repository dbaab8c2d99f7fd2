// More pairs than a space keeps (dxPairKeeping). The callbacks are Debian's, and the memory is not that of all pairs.
//
// Covers dxOrderedHashSpace.cpp, dxOrderedSpace.cpp, dxSpacePairs.cpp.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "support/child_run.h"
#include "numbered_spaces.h"
#include "sanitizers.h"

namespace {

struct Outcome {
    std::string ending, callbacks;
    int megabytes = 0;
};

Outcome run(const char *libraryFolder, int kind, const char *threads) {
    const auto child = support::runProgram({ODE_MT_CROWD_PROGRAM, std::to_string(kind)},
                                           {{"LD_LIBRARY_PATH", libraryFolder}, {"ODE_MT_THREADS", threads}});
    const std::string label = "memory ";
    const auto at = child.output.rfind(label);
    if (at == std::string::npos) return {child.text(), child.output + child.errors, 0};
    return {child.text(), child.output.substr(0, at), std::atoi(child.output.c_str() + at + label.size())};
}

class Crowd : public testing::TestWithParam<int> {};

TEST_P(Crowd, IsCollidedAsByLibode8) {
    const Outcome stock = run(ODE_MT_STOCK_LIBRARY_DIR, GetParam(), "");
    ASSERT_EQ(stock.ending, "exit code 0") << stock.callbacks;
    for (const char *const threads : {"0", "2", "3"}) {
        const Outcome ours = run(ODE_MT_LIBRARY_DIR, GetParam(), threads);
        EXPECT_EQ(ours.ending, "exit code 0");
        EXPECT_EQ(ours.callbacks, stock.callbacks) << threads << " threads";
        const bool isHash = GetParam() == 1;  // it keeps up to four million
        if (!kAddressSanitizer && !kThreadSanitizer) {
            EXPECT_LT(ours.megabytes, isHash ? 600 : 80);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Crowd, testing::Range(0, 4),
                         [](const auto &info) { return std::string(kKinds[info.param]); });

}  // namespace
