// What the tools print and write, where that cannot be done: each says so, and no older file is lost. All ways of
// writing, for all three tools.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "shell_run.h"

namespace {

class ToolOutput : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder);
        const Outcome outcome = runShell(std::string(ODEMT_RECORD) + " rover:2 --frames 5 --output " + recording);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.output;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    // The file is whole and what it was, and nothing else is beside it.
    void expectKept(const std::string &command) const {
        std::ifstream stream(kept);
        const std::string text((std::istreambuf_iterator<char>(stream)), {});
        EXPECT_EQ(text, "of old\n") << command;
        for (const auto &entry : std::filesystem::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            EXPECT_TRUE(name == "kept" || name == "recording" || name == "x.csv") << name << " is left by " << command;
        }
    }
    void writeKept() const { std::ofstream(kept) << "of old\n"; }

    const std::string folder = testing::TempDir() + "/tool_output_" + std::to_string(getpid());
    const std::string recording = folder + "/recording", kept = folder + "/kept";
    const std::string bench = std::string(ODEMT_BENCH) + " --worlds rover:3 --engines ours:0 --frames 20";
    const std::string benchFiles = " --json " + folder + "/x.json --csv " + folder + "/x.csv";
    const std::string record = std::string(ODEMT_RECORD) + " rover:2 --frames 5";
    const std::string report = std::string(ODEMT_REPORT) + " --recording " + recording;
};

TEST_F(ToolOutput, AStandardOutputThatIsFullOrClosedIsAnError) {
    for (const std::string &command : {std::string(ODEMT_BENCH) + " --list", std::string(ODEMT_BENCH) + " --help",
                                       bench + benchFiles, std::string(ODEMT_RECORD) + " --help", record,
                                       std::string(ODEMT_RECORD) + " epuck --frames 5",
                                       std::string(ODEMT_REPORT) + " --help"}) {
        EXPECT_EQ(runShell(command + " >/dev/null").exitCode, 0) << command;
        for (const char *const where : {" >/dev/full", " >&-"}) {
            const Outcome outcome = runShell(command + where);
            EXPECT_EQ(outcome.exitCode, 1) << command << where << ": " << outcome.output;
            EXPECT_NE(outcome.output.find("cannot write to standard output: "), std::string::npos)
                << command << where << ": " << outcome.output;
        }
    }
}

TEST_F(ToolOutput, AFileThatCannotBeWrittenIsNamedWithTheReason) {
    const std::string pipeName = folder + "/pipe", loop = folder + "/loop";
    const std::vector<std::pair<std::string, std::string>> files = {
        {folder, "it is a folder"},
        {"/dev/full", "No space left on device"},
        {"/proc/none/x", "No such file or directory"},
        {recording + "/x", "Not a directory"},
        {pipeName, "it is a named pipe"},
        {loop, "Too many levels of symbolic links"}};
    mkfifo(pipeName.c_str(), 0600);
    symlink(loop.c_str(), loop.c_str());
    for (const std::string &command :
         {bench + " --csv /dev/null --json ", bench + " --json /dev/null --csv ", record + " --output ",
          report + " --output "})
        for (const auto &[file, reason] : files) {
            const Outcome outcome = runShell(command + file);
            EXPECT_TRUE(outcome.exitCode == 1 || outcome.exitCode == 2) << command << file << ": " << outcome.output;
            EXPECT_NE(outcome.output.find("cannot write '" + file + "': " + reason), std::string::npos)
                << command << file << ": " << outcome.output;
        }
}

TEST_F(ToolOutput, WhatFailsLeavesTheOldFile) {
    const std::string badBench = std::string(ODEMT_BENCH) + " --engines ours:0 --frames 20 --worlds ",
                      csv = " --csv " + folder + "/x.csv --json ";
    for (const std::string &command :
         {badBench + "/none.sdf" + csv, "ulimit -f 0; " + bench + csv, std::string(ODEMT_RECORD) + " /none.sdf --output ",
          "ulimit -f 0; " + record + " --output ", std::string(ODEMT_REPORT) + " /dev/null --output ",
          "ulimit -f 0; " + report + " --output "}) {
        writeKept();
        const Outcome outcome = runShell(command + kept);
        EXPECT_NE(outcome.exitCode, 0) << command << ": " << outcome.output;
        EXPECT_LE(outcome.exitCode, 2) << command << ": " << outcome.output;  // no signal
        expectKept(command);
    }
}

// Neither the world nor the recording, which are inputs, is overwritten.
TEST_F(ToolOutput, WhatIsReadIsNotWrittenTo) {
    const std::string world = folder + "/world.sdf", link = folder + "/link";
    const std::string original = "<sdf version=\"1.9\"><world name=\"w\"/></sdf>\n";
    std::ofstream(world) << original;
    std::filesystem::create_symlink(world, link);
    for (const std::string &command :
         {std::string(ODEMT_RECORD) + " " + world + " --frames 5 --output " + world,
          std::string(ODEMT_RECORD) + " " + world + " --frames 5 --output " + link,
          std::string(ODEMT_BENCH) + " --engines ours:0 --frames 5 --worlds " + world + " --csv /dev/null --json " + link,
          report + " --output " + recording}) {
        const Outcome outcome = runShell(command);
        EXPECT_NE(outcome.exitCode, 0) << command;
        EXPECT_NE(outcome.output.find("are one file"), std::string::npos) << command << ": " << outcome.output;
        std::ifstream stream(world);
        EXPECT_EQ(std::string((std::istreambuf_iterator<char>(stream)), {}), original) << command;
    }
}

TEST_F(ToolOutput, ControlCharactersAreShownAndNotSent) {
    const std::string name = "'\x1b[31m\a'";
    for (const std::string &command :
         {std::string(ODEMT_BENCH) + " --frames " + name, std::string(ODEMT_BENCH) + " --manager " + name,
          std::string(ODEMT_BENCH) + " --worlds " + name, std::string(ODEMT_BENCH_CHILD) + " --pool " + name,
          std::string(ODEMT_RECORD) + " " + name, record + " --cells " + name, std::string(ODEMT_REPORT) + " --output x " + name}) {
        const Outcome outcome = runShell(command);
        EXPECT_EQ(outcome.exitCode, 2) << command;
        EXPECT_NE(outcome.output.find("\\x1b[31m\\x07"), std::string::npos) << outcome.output;
        EXPECT_EQ(outcome.output.find_first_of("\x1b\a"), std::string::npos) << command;
    }
}

TEST_F(ToolOutput, TheChildEndsAsTheOthersDo) {
    const std::string child = "echo '{\"frames\":1}' | " ODEMT_BENCH_CHILD;
    const auto expect = [&](const std::string &arguments, int exitCode, const std::string &words) {
        const Outcome outcome = runShell(child + arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments << ": " << outcome.output;
        EXPECT_NE(outcome.output.find(words), std::string::npos) << arguments << ": " << outcome.output;
    };
    expect(" --world rover:1", 0, "\"batch\"");
    expect(" --world rover:1 --nosuch", 2, "--nosuch");
    expect(" --world rover:1 --pool 4294967295", 2, "from 0 to 1024");
    expect(" --world nosuch", 1, "nosuch");
    expect(" --world rover:1 >/dev/full", 1, "cannot write to standard output");
    expect(" --world rover:1 >&-", 1, "cannot write to standard output");
}

TEST_F(ToolOutput, LongNamesAndDevicesAreWrittenTo) {
    const std::string longName = folder + "/" + std::string(250, 'a');
    EXPECT_EQ(runShell(report + " --output " + longName).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(longName));
    const Outcome outcome = runShell(report + " --output /dev/stdout | cat");
    EXPECT_NE(outcome.output.find("<!DOCTYPE html>"), std::string::npos) << outcome.output.substr(0, 200);
    const Outcome unnamed = runShell(bench + " --json '' --csv /dev/null");
    EXPECT_EQ(unnamed.exitCode, 2);
    EXPECT_NE(unnamed.output.find("--json: "), std::string::npos) << unnamed.output;
}

TEST_F(ToolOutput, ARecordingThatIsKilledLeavesTheOldFileAndItsFrames) {
    writeKept();
    runShell(std::string(ODEMT_RECORD) + " rover:2 --frames 1000000000 --output " + kept + " & P=$!; sleep 1; kill -9 $P; wait");
    std::ifstream stream(kept);
    EXPECT_EQ(std::string((std::istreambuf_iterator<char>(stream)), {}), "of old\n");
    int frames = 0;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().filename().string().rfind("kept.", 0) != 0) continue;
        std::ifstream part(entry.path());
        for (std::string line; std::getline(part, line);) frames += line.find("\"frame\"") != std::string::npos;
    }
    EXPECT_GT(frames, 1);
}

}  // namespace
