#include "child_process.h"

#include <gtest/gtest.h>

using namespace bench;
using namespace std::chrono_literals;

namespace {

std::vector<std::string> shell(const std::string &script) { return {"/bin/sh", "-c", script}; }

std::string complaint(const std::string &script, std::chrono::milliseconds limit) {
    ChildProcess child(shell(script), {});
    try {
        child.readLine(limit);
    } catch (const ChildError &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(ChildProcess, AnswersLinesWithLines) {
    ChildProcess child(shell("while read word; do echo \"<$word>\"; done"), {});
    for (const char *word : {"one", "two"}) {
        child.writeLine(word);
        EXPECT_EQ(child.readLine(10s), "<" + std::string(word) + ">");
    }
}

TEST(ChildProcess, KeepsLinesThatCameTogether) {
    ChildProcess child(shell("printf 'a\\nb\\n'"), {});
    EXPECT_EQ(child.readLine(10s), "a");
    EXPECT_EQ(child.readLine(10s), "b");
}

TEST(ChildProcess, EnvironmentIsOursWithChanges) {
    setenv("BENCH_TEST_KEPT", "kept", 1);
    setenv("BENCH_TEST_REMOVED", "removed", 1);
    ChildProcess child(shell("echo $BENCH_TEST_KEPT-$BENCH_TEST_REMOVED-$BENCH_TEST_NEW"),
                       {{"BENCH_TEST_REMOVED", ""}, {"BENCH_TEST_NEW", "new"}});
    EXPECT_EQ(child.readLine(10s), "kept--new");
}

TEST(ChildProcess, AnExitCodeIsReported) { EXPECT_EQ(complaint("exit 3", 10s), "ended with exit code 3"); }

TEST(ChildProcess, ACrashIsReportedBySignal) {
    const std::string text = complaint("kill -SEGV $$", 10s);
    EXPECT_NE(text.find("killed by signal 11"), std::string::npos) << text;
    EXPECT_NE(text.find("Segmentation fault"), std::string::npos) << text;
}

TEST(ChildProcess, LastWordsAreReported) {
    EXPECT_EQ(complaint("echo assertion failed >&2; exit 134", 10s),
              "ended with exit code 134: assertion failed");
}

TEST(ChildProcess, AHangIsReported) { EXPECT_EQ(complaint("sleep 60", 1000ms), "no answer within 1 s"); }

TEST(ChildProcess, AChildThatHasEndedCannotBeWrittenTo) {
    ChildProcess child(shell("exec <&-; echo closed; exit 5"), {});
    EXPECT_EQ(child.readLine(10s), "closed");
    EXPECT_THROW(
        {
            for (int i = 0; i < 3; ++i) child.writeLine("x");
            child.readLine(10s);
        },
        ChildError);
}

TEST(ChildProcess, AMissingProgramIsNamed) {
    try {
        ChildProcess child({"/no/such/program"}, {});
        FAIL();
    } catch (const ChildError &error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos);
    }
}
