// Geoms added clean in front of dirty ones: upstream never cleans those behind and fails an assertion where they
// meet something (docs/collision.md). Ours ends in the same way, with the same text, or continues in the same way.
//
// Covers dxListCleaner.cpp.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "support/child_run.h"

namespace {

struct Outcome {
    std::string ending, output, errors;
};

// Without file and line of the assertion.
Outcome run(const char *libraryFolder, bool hash, int moved, int added) {
    const auto child = support::runProgram(
        {ODE_MT_CLEAN_BEFORE_DIRTY_PROGRAM, hash ? "1" : "0", std::to_string(moved), std::to_string(added)},
        {{"LD_LIBRARY_PATH", libraryFolder}});
    return {child.text(), child.output, std::regex_replace(child.errors, std::regex("\\[[^\\]]*:[0-9]+\\]"), "[]")};
}

class CleanBeforeDirty : public testing::TestWithParam<bool> {};

TEST_P(CleanBeforeDirty, EndsAsUnderLibode8) {
    const bool hash = GetParam();
    int aborted = 0, survived = 0;
    for (const int moved : {0, 1, 3, 4, 10, 21, 32, 63})
        for (const int added : {1, 2, 8, 12, 31, 42}) {
            const Outcome stock = run(ODE_MT_STOCK_LIBRARY_DIR, hash, moved, added);
            const Outcome ours = run(ODE_MT_LIBRARY_DIR, hash, moved, added);
            EXPECT_EQ(ours.ending, stock.ending) << "moved " << moved << ", added " << added;
            EXPECT_EQ(ours.output, stock.output) << "moved " << moved << ", added " << added;
            EXPECT_EQ(ours.errors, stock.errors) << "moved " << moved << ", added " << added;
            (stock.ending == "exit code 0" ? survived : aborted) += 1;
            if (stock.ending != "exit code 0") {
                EXPECT_NE(stock.errors.find("assertion"), std::string::npos);
            }
        }
    EXPECT_GT(aborted, 5);
    EXPECT_GT(survived, 5);
}

INSTANTIATE_TEST_SUITE_P(Spaces, CleanBeforeDirty, testing::Values(false, true),
                         [](const auto &info) { return info.param ? "hash" : "simple"; });

}  // namespace
