#include "process/line_process.h"

#include <gtest/gtest.h>

using namespace process;
using namespace std::chrono_literals;

namespace {

std::vector<std::string> shell(const std::string &script) { return {"/bin/sh", "-c", script}; }

std::string complaint(const std::string &script, std::chrono::milliseconds limit) {
    LineProcess child(shell(script), {});
    try {
        child.readLine(limit);
    } catch (const LineProcessError &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(LineProcess, AnswersLinesWithLines) {
    LineProcess child(shell("while read word; do echo \"<$word>\"; done"), {});
    for (const char *word : {"one", "two"}) {
        child.writeLine(word);
        EXPECT_EQ(child.readLine(10s), "<" + std::string(word) + ">");
    }
}

TEST(LineProcess, CallsBackWhileItWaits) {
    LineProcess child(shell("sleep 1; echo a; echo b"), {});
    int calls = 0;
    EXPECT_EQ(child.readLine(10s, [&] { ++calls; }), "a");
    EXPECT_GE(calls, 1);
    EXPECT_LE(calls, 10);
    EXPECT_THROW(LineProcess(shell("sleep 60"), {}).readLine(500ms, [] {}), LineProcessError);
}

TEST(LineProcess, KeepsLinesThatCameTogether) {
    LineProcess child(shell("printf 'a\\nb\\n'"), {});
    EXPECT_EQ(child.readLine(10s), "a");
    EXPECT_EQ(child.readLine(10s), "b");
}

TEST(LineProcess, EnvironmentIsOursWithChanges) {
    setenv("BENCH_TEST_KEPT", "kept", 1);
    setenv("BENCH_TEST_REMOVED", "removed", 1);
    LineProcess child(shell("echo $BENCH_TEST_KEPT-$BENCH_TEST_REMOVED-$BENCH_TEST_NEW"),
                       {{"BENCH_TEST_REMOVED", ""}, {"BENCH_TEST_NEW", "new"}});
    EXPECT_EQ(child.readLine(10s), "kept--new");
}

TEST(LineProcess, AnExitCodeIsReported) { EXPECT_EQ(complaint("exit 3", 10s), "ended with exit code 3"); }

TEST(LineProcess, ACrashIsReportedBySignal) {
    const std::string text = complaint("kill -SEGV $$", 10s);
    EXPECT_NE(text.find("killed by signal 11"), std::string::npos) << text;
    EXPECT_NE(text.find("Segmentation fault"), std::string::npos) << text;
}

TEST(LineProcess, LastWordsAreReported) {
    EXPECT_EQ(complaint("echo assertion failed >&2; exit 134", 10s),
              "ended with exit code 134: assertion failed");
}

TEST(LineProcess, AHangIsReported) { EXPECT_EQ(complaint("sleep 60", 1000ms), "no answer within 1 s"); }

TEST(LineProcess, AChildThatHasEndedCannotBeWrittenTo) {
    LineProcess child(shell("exec <&-; echo closed; exit 5"), {});
    EXPECT_EQ(child.readLine(10s), "closed");
    EXPECT_THROW(
        {
            for (int i = 0; i < 3; ++i) child.writeLine("x");
            child.readLine(10s);
        },
        LineProcessError);
}

TEST(LineProcess, AMissingProgramIsNamed) {
    try {
        LineProcess child({"/no/such/program"}, {});
        FAIL();
    } catch (const LineProcessError &error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos);
    }
}

TEST(LineProcess, AnEndThatWasAskedForIsWaitedFor) {
    LineProcess child(shell("while read word; do echo $word; done; exit 0"), {});
    child.writeLine("a");
    child.writeEnd();
    EXPECT_EQ(child.readLine(10s), "a");
    child.waitForExit();
    LineProcess failing(shell("read word; exit 4"), {});
    failing.writeEnd();
    EXPECT_THROW(failing.waitForExit(), LineProcessError);
}
