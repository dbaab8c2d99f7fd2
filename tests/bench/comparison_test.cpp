#include "comparison.h"

#include "complaint.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

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

TEST_F(Comparison, WhatOnlyOneHasIsLeftOut) {
    const std::string one = file("one", engine("ours:2", "1.4", "1.5", "1.6")), failed = file("failed", engine("ours:2", "null", "null", "null", "died")),
                      other = file("other", engine("ours:4", "1.4", "1.5", "1.6"));
    EXPECT_EQ(compareResults(one, failed).find("ours:2"), std::string::npos);
    EXPECT_EQ(compareResults(one, other).find("ours"), std::string::npos);
}

TEST_F(Comparison, OtherFilesAreNamed) {
    const std::string one = file("one", engine("ours:2", "1.4", "1.5", "1.6")), empty = folder + "/empty";
    EXPECT_NE(complaint([&] { compareResults(one, folder + "/none"); }).find("none"), std::string::npos);
    std::ofstream(empty) << "{\"worlds\":[]}";
    EXPECT_NE(complaint([&] { compareResults(one, empty); }).find("in common"), std::string::npos);
    std::ofstream(empty) << "{}";
    EXPECT_NE(complaint([&] { compareResults(empty, one); }).find("no results of odemt_bench"), std::string::npos);
}
