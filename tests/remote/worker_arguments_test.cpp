// Options of odemt_worker: units, and what is refused with its name.
#include "remote/worker/dxWorkerArguments.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

std::string read(const std::vector<std::string> &words, dxWorkerArguments &arguments) { return dxReadWorkerArguments(words, arguments); }

TEST(WorkerArguments, AreReadWithTheirUnits) {
    dxWorkerArguments arguments;
    ASSERT_EQ(read({"--delay", "50us", "--bandwidth", "125MB/s", "--record", "a file"}, arguments), "");
    EXPECT_DOUBLE_EQ(arguments.link.delayNs, 50e3);
    EXPECT_DOUBLE_EQ(arguments.link.nsPerByte, 8);
    EXPECT_EQ(arguments.record, "a file");
    ASSERT_EQ(read({"--delay", "1.5ms", "--bandwidth", "1Gbit/s"}, arguments), "");
    EXPECT_DOUBLE_EQ(arguments.link.delayNs, 1.5e6);
    EXPECT_DOUBLE_EQ(arguments.link.nsPerByte, 8);
}

TEST(WorkerArguments, WithoutThemTheLinkIsThatWhichIsThere) {
    dxWorkerArguments arguments;
    EXPECT_EQ(read({}, arguments), "");
    EXPECT_FALSE(arguments.link.isThere());
}

TEST(WorkerArguments, WhatIsWrongIsNamed) {
    dxWorkerArguments arguments;
    for (const char *const time : {"", "us", "50", "-1us", "nanus", "2s", "1e999s", "50us "})
        EXPECT_NE(read({"--delay", time}, arguments), "") << time;
    for (const char *const rate : {"0B/s", "1", "1Gb/s", "1 GB/s"}) EXPECT_NE(read({"--bandwidth", rate}, arguments), "") << rate;
    EXPECT_EQ(read({"--delay"}, arguments), "--delay: its value is missing");
    EXPECT_EQ(read({"--later", "1us"}, arguments), "unknown option '--later'");
}

TEST(WorkerArguments, OfTheEnvironmentAreWords) {
    setenv("ODEMT_WORKER_ARGUMENTS", " --delay  1ms\n", 1);
    EXPECT_EQ(dxWorkerArgumentsOfEnvironment(), (std::vector<std::string>{"--delay", "1ms"}));
    unsetenv("ODEMT_WORKER_ARGUMENTS");
    EXPECT_TRUE(dxWorkerArgumentsOfEnvironment().empty());
}

}  // namespace
