// odemt_report as a user runs it. What a browser makes of its pages is tested in tests/report.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "shell_run.h"

namespace {

class OdemtReport : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder);
        std::ofstream(results) << R"({"machine":{},"worlds":[{}]})";
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    Outcome report(const std::string &arguments) const { return runShell(std::string(ODEMT_REPORT) + " " + arguments); }
    std::string text() const {
        std::ifstream stream(page);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    const std::string folder = testing::TempDir() + "/odemt_report_" + std::to_string(getpid());
    const std::string results = folder + "/b.json", recording = folder + "/r.jsonl", page = folder + "/p.html";
};

}  // namespace

TEST_F(OdemtReport, WritesResultsAndRecordings) {
    ASSERT_EQ(runShell(std::string(ODEMT_RECORD) + " rover:2 --frames 20 --output " + recording).exitCode, 0);
    const Outcome outcome = report(results + " --recording " + recording + " --recording " + recording + " --output " + page);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    const std::string text = this->text();
    EXPECT_EQ(text.compare(0, 15, "<!DOCTYPE html>"), 0);
    EXPECT_NE(text.find("id=\"results\""), std::string::npos);
    EXPECT_NE(text.find("class=\"recording\""), text.rfind("class=\"recording\""));
}

TEST_F(OdemtReport, RecordingsOfDifferentWorldsAreWarnedOf) {
    const std::string other = folder + "/other.jsonl";
    ASSERT_EQ(runShell(std::string(ODEMT_RECORD) + " rover:2 --frames 3 --output " + recording).exitCode, 0);
    ASSERT_EQ(runShell(std::string(ODEMT_RECORD) + " rover:3 --frames 3 --output " + other).exitCode, 0);
    const auto both = [&](const std::string &second) { return report("--recording " + recording + " --recording " + second + " --output " + page); };
    EXPECT_EQ(both(recording).output, "");
    const Outcome outcome = both(other);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("different worlds: 'rover:2' and 'rover:3'"), std::string::npos) << outcome.output;
    EXPECT_NE(text().find("different worlds: 'rover:2' and 'rover:3'"), std::string::npos);
}

// As docs/notes/2026-11-cost-of-observation.md says: 0.8 MB, and about half of each recording's file.
TEST_F(OdemtReport, PagesAreAsLargeAsDocumented) {
    ASSERT_EQ(runShell(std::string(ODEMT_RECORD) + " pile:100 --frames 60 --every 3 --output " + recording).exitCode, 0);
    report(results + " --output " + page);
    const auto without = std::filesystem::file_size(page), file = std::filesystem::file_size(recording);
    EXPECT_NEAR(static_cast<double>(without), 0.8e6, 0.2e6);
    report("--recording " + recording + " --output " + page);
    EXPECT_LT(std::filesystem::file_size(page), without + file * 6 / 10);
}

TEST_F(OdemtReport, WhatIsWrongIsNamed) {
    std::ofstream(recording) << "no JSON\n";
    const std::string empty = folder + "/empty", output = " --output " + page, twice = " --recording " + recording + " --recording " + recording;
    std::ofstream{empty};
    for (const auto &[arguments, code, word] : std::vector<std::tuple<std::string, int, std::string>>{
             {"--output " + page, 2, "--recording"},
             {results, 2, "--output"},
             {"missing" + output, 2, "missing"},
             {results + twice + " --recording " + recording + output, 2, "at most two"},
             {results + " --output " + results, 2, "one file"},
             {results + " --recording " + recording + " --output " + recording, 2, "one file"},
             {"--recording " + recording + output, 1, "line 1"},
             {recording + output, 1, "no results of odemt_bench"},
             {empty + output, 1, "empty"},
             {results + " --output /proc/p.html", 1, "/proc/p.html"}}) {
        const Outcome outcome = report(arguments);
        EXPECT_EQ(outcome.exitCode, code) << arguments << outcome.output;
        EXPECT_NE(outcome.output.find(word), std::string::npos) << outcome.output;
        EXPECT_FALSE(std::filesystem::exists(page));
    }
}
