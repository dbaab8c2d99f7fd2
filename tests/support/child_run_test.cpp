#include "support/child_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

using namespace support;

namespace {

std::vector<std::string> shell(const std::string &script) { return {"/bin/sh", "-c", script}; }

}  // namespace

TEST(RunProgram, KeepsWhatAProgramWroteAndHowItEnded) {
    const Ending ending = runProgram(shell("echo $ODD; echo wrong >&2; exit 3"), {{"ODD", "out"}});
    EXPECT_TRUE(ending.exitedWith(3));
    EXPECT_FALSE(ending.exitedWith(0));
    EXPECT_EQ(ending.text(), "exit code 3");
    EXPECT_EQ(ending.output, "out\n");
    EXPECT_EQ(ending.errors, "wrong\n");
    EXPECT_TRUE(runProgram(shell("kill -ABRT $$"), {}).killedBy(SIGABRT));
    EXPECT_THROW(runProgram({"/no/such/program"}, {}), std::runtime_error);
}

TEST(RunProgram, EndsWhatTakesTooLong) {
    Limits limits;
    limits.seconds = 0.2;
    const Ending ending = runProgram({"sleep", "60"}, {}, limits);
    EXPECT_TRUE(ending.ranOutOfTime);
    EXPECT_FALSE(ending.exited());
    EXPECT_EQ(ending.text(), "time over");
}

TEST(RunFunction, HasStandardFilesOfItsOwn) {
    const auto work = [] {
        std::string word;
        std::cin >> word;
        std::cout << "<" << word << ">";
        std::fputs("to C's output", stdout);
        std::cerr << "to errors";
        return 7;
    };
    const Ending ending = runFunction(work, {}, "input");
    EXPECT_TRUE(ending.exitedWith(7));
    EXPECT_NE(ending.output.find("<input>"), std::string::npos) << ending.output;
    EXPECT_NE(ending.output.find("to C's output"), std::string::npos) << ending.output;
    EXPECT_EQ(ending.errors, "to errors");
    EXPECT_GT(ending.peakMemory, 0u);
}

TEST(RunFunction, AnExceptionEndsTheChildAlone) {
    const Ending ending = runFunction([]() -> int { throw std::runtime_error("no way"); }, {});
    EXPECT_TRUE(ending.exitedWith(127));
    EXPECT_EQ(ending.errors, "an exception: no way\n");
    EXPECT_TRUE(runFunction([]() -> int { throw 1; }, {}).exitedWith(127));
}

TEST(RunFunction, KillsWhatIsLeftRunning) {
    const Ending ending = runFunction(
        [] {
            if (fork() == 0) pause();
            return 0;
        },
        {});
    EXPECT_TRUE(ending.exitedWith(0));
    EXPECT_TRUE(ending.leftProcesses);
    EXPECT_FALSE(runFunction([] { return 0; }, {}).leftProcesses);
}

TEST(RunFunction, LimitsTimeAndMemory) {
    Limits limits;
    limits.cpuSeconds = 1;
    const Ending busy = runFunction(
        []() -> int {
            for (volatile unsigned i = 0;; i = i + 1) {
            }
        },
        limits);
    EXPECT_TRUE(busy.ranOutOfTime) << busy.text();
    EXPECT_GT(busy.cpuSeconds, 0.3);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    limits.memory = std::size_t{256} << 20;
    const Ending large = runFunction(
        []() -> int {
            std::string text(std::size_t{512} << 20, 'x');
            pause();
            return text.empty() ? 1 : 0;
        },
        limits);
    EXPECT_EQ(large.text(), "memory over");
#endif
}

TEST(RunInChild, TellsWhetherAFunctionReturned) {
    EXPECT_TRUE(runInChild([] {}).exitedWith(0));
    EXPECT_TRUE(runInChild([] { std::abort(); }).killedBy(SIGABRT));
    EXPECT_TRUE(trueInChild([] { return true; }));
    EXPECT_FALSE(trueInChild([] { return false; }));
}
