#include "support/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace support;
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

TEST(Process, AStatusIsSaidInWords) {
    EXPECT_EQ(endingOf(waitFor(spawn(shell("exit 2"), {}, {}))), "exit code 2");
    EXPECT_EQ(endingOf(waitFor(spawn(shell("kill -ABRT $$"), {}, {}))), "signal 6 (Aborted)");
    EXPECT_THROW(spawn({"/no/such/program"}, {}, {}), std::runtime_error);
}

TEST(Process, AFileInMemoryTakesWhatSeveralProcessesWrite) {
    const MemoryFile file;
    const pid_t first = spawn(shell("echo one; sh -c 'echo two'"), {}, {-1, file.descriptor(), -1});
    waitFor(first);
    waitFor(spawn(shell("echo three"), {}, {-1, file.descriptor(), -1}));
    EXPECT_EQ(file.text(), "one\ntwo\nthree\n");
    EXPECT_EQ(file.size(), 14u);
    EXPECT_EQ(file.text(8), "three\n");
    EXPECT_EQ(file.text(99), "");
    file.write("anew");
    EXPECT_EQ(file.text(), "anew");
}

TEST(Process, ADescriptorIsClosedWithItsObject) {
    int number = -1;
    {
        Pipe pipe;
        number = pipe.reading.number();
        Descriptor taken = std::move(pipe.reading);
        EXPECT_EQ(taken.number(), number);
        EXPECT_EQ(pipe.reading.number(), -1);
        EXPECT_EQ(fcntl(number, F_GETFD), FD_CLOEXEC);
    }
    EXPECT_EQ(fcntl(number, F_GETFD), -1);
}

TEST(PipedProcess, HasOneStatusHoweverOftenItIsAsked) {
    PipedProcess child(shell("cat; exit 3"), {});
    EXPECT_FALSE(child.hasEnded());
    child.closeInput();
    const int status = child.wait();
    EXPECT_EQ(endingOf(status), "exit code 3");
    EXPECT_TRUE(child.hasEnded());
    EXPECT_EQ(child.wait(), status);
}

TEST(ForkedChild, EndsWithThisProcess) {
    Pipe pipe;
    const pid_t parent = fork();
    if (parent == 0) {
        if (forkChild() == 0) pause();
        _exit(0);
    }
    waitFor(parent);
    pipe.writing.close();
    char byte = 0;
    EXPECT_EQ(read(pipe.reading.number(), &byte, 1), 0);  // the end of the file: nobody has its other end
}
