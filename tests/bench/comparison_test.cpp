#include "comparison.h"

#include "complaint.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <tuple>

using namespace bench;

namespace {

class Comparison : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    static std::string engine(const std::string &name, const std::string &lower, const std::string &median, const std::string &upper,
                              const std::string &failure = "") {
        return R"({"engine":")" + name + R"(","failure":")" + failure + R"(","parts":{"frame":{"meanSeconds":0.002,"speedUp":{"lowerQuartile":)" +
               lower + ",\"median\":" + median + ",\"upperQuartile\":" + upper + "}}}}";
    }

    std::string file(const std::string &name, const std::string &ours) const {
        std::ofstream(folder + "/" + name) << R"({"worlds":[{"world":"pile","engines":[)" << engine("stock", "1", "1", "1") << "," << ours << "]}]}";
        return folder + "/" + name;
    }

    const std::string folder = testing::TempDir() + "/comparison_" + std::to_string(getpid());
};

}  // namespace

TEST_F(Comparison, WhatDoesNotOverlapIsFasterOrSlower) {
    const std::string slow = file("slow", engine("ours:2", "1.4", "1.5", "1.6")), fast = file("fast", engine("ours:2", "1.7", "1.8", "1.9")),
                      wide = file("wide", engine("ours:2", "1.5", "1.7", "1.9"));
    EXPECT_NE(compareResults(slow, fast).find("1.50 [1.40, 1.60]  1.80 [1.70, 1.90]  faster"), std::string::npos) << compareResults(slow, fast);
    EXPECT_NE(compareResults(fast, slow).find("  slower\n"), std::string::npos);
    EXPECT_NE(compareResults(slow, wide).find("no difference"), std::string::npos);
    EXPECT_NE(compareResults(slow, wide).find("reference"), std::string::npos);
}

// Returns the line of an engine in a table; empty: it has none.
static std::string lineOf(const std::string &table, const std::string &words) {
    const std::size_t at = table.find(words), begin = table.rfind('\n', at) + 1;
    return at == std::string::npos ? "" : table.substr(begin, table.find('\n', at) - begin);
}

TEST_F(Comparison, WhatOnlyOneHasIsMarked) {
    const std::string figures = engine("ours:2", "1.4", "1.5", "1.6"), one = file("one", figures),
                      other = file("other", engine("ours:4", "1.6", "1.7", "1.8")),
                      failed = file("failed", engine("ours:2", "null", "null", "null", "died")),
                      otherFailed = file("other_failed", engine("ours:4", "null", "null", "null", "died"));
    EXPECT_EQ(lineOf(compareResults(one, other), "ours:2"), "pile   ours:2       2.00      -  1.50 [1.40, 1.60]                  -  only before");
    EXPECT_EQ(lineOf(compareResults(one, other), "ours:4"), "pile   ours:4          -   2.00                  -  1.70 [1.60, 1.80]  only after");
    for (const auto &[before, after, engine, mark] : {std::tuple(one, failed, "ours:2", "  failed after"),
                                                      {failed, one, "ours:2", "  failed before"},
                                                      {failed, failed, "ours:2", "  failed in both"},
                                                      {one, otherFailed, "ours:4", "  only after, failed"},
                                                      {otherFailed, one, "ours:4", "  only before, failed"}}) {
        const std::string line = lineOf(compareResults(before, after), engine), words = mark;
        EXPECT_EQ(line.substr(line.size() - std::min(line.size(), words.size())), words) << line;
    }
}

// A world that was added, or named in another way.
TEST_F(Comparison, WorldsThatOnlyOneHasAreMarked) {
    const std::string one = file("one", engine("ours:2", "1.4", "1.5", "1.6")), two = folder + "/two";
    std::ofstream(two) << R"({"worlds":[{"world":"wall","engines":[)" << engine("stock", "1", "1", "1") << R"(]},{"world":"pile","engines":[)"
                       << engine("stock", "1", "1", "1") << "]}]}";
    EXPECT_NE(lineOf(compareResults(one, two), "wall").find("only after"), std::string::npos);
    EXPECT_NE(lineOf(compareResults(two, one), "wall").find("only before"), std::string::npos);
    EXPECT_NE(lineOf(compareResults(two, one), "ours:2").find("only after"), std::string::npos);
}

TEST_F(Comparison, OtherFilesAreNamed) {
    const std::string one = file("one", engine("ours:2", "1.4", "1.5", "1.6")), empty = folder + "/empty";
    EXPECT_NE(complaint([&] { compareResults(one, folder + "/none"); }).find("none"), std::string::npos);
    std::ofstream(empty) << "{\"worlds\":[]}";
    EXPECT_NE(complaint([&] { compareResults(one, empty); }).find("in common"), std::string::npos);
    std::ofstream(empty) << "{}";
    EXPECT_NE(complaint([&] { compareResults(empty, one); }).find("no results of odemt_bench"), std::string::npos);
}
