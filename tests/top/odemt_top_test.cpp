// odemt_top as users call it. stepper.c says what the program does.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <thread>

#include "../bench/shell_run.h"

namespace {

using namespace std::chrono_literals;

Outcome run(const std::string &options, const std::string &program = STEPPER) { return runShell(ODEMT_TOP " " + options + " -- " + program); }

void expectWords(const std::string &text, const std::string &words) {
    EXPECT_NE(text.find(words), std::string::npos) << text << "\nhas not: " << words;
}

void expectLine(const std::string &text, const std::string &pattern) {
    EXPECT_TRUE(std::regex_search(text, std::regex(pattern))) << text << "\nhas not: " << pattern;
}

std::size_t count(const std::string &text, const std::string &words) {
    std::size_t found = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
    return found;
}

std::string read(const std::string &file) {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

// Waits for it.
bool hasWords(const std::string &file, const std::string &words) {
    for (const auto limit = std::chrono::steady_clock::now() + 20s; std::chrono::steady_clock::now() < limit; std::this_thread::sleep_for(10ms))
        if (read(file).find(words) != std::string::npos) return true;
    return false;
}

// Not ended, nor waiting for its parent.
bool isRunning(const std::string &process) {
    const std::string number = std::to_string(std::stol(process));
    return runShell("kill -0 " + number + " && ! grep -q '^State:.Z' /proc/" + number + "/status").exitCode == 0;
}

class OdemtTop : public testing::Test {
protected:
    OdemtTop() {
        std::filesystem::create_directory(folder);
        setenv("TMPDIR", folder.c_str(), 1);
        unsetenv("ODE_MT_THREADS");
    }
    ~OdemtTop() override {
        setenv("TMPDIR", folderOfAll.c_str(), 1);
        std::filesystem::remove_all(folder);
    }

    const std::string folderOfAll = testing::TempDir();
    const std::string folder = folderOfAll + "odemt_top_test_" + std::to_string(getpid()), output = folder + "/output";
};

TEST_F(OdemtTop, OneTableAtTheEnd) {
    const Outcome outcome = run("--once --threads 2", STEPPER " 2 60");
    EXPECT_EQ(outcome.exitCode, 0);
    expectWords(outcome.output, "s, all frames on average\n");
    expectLine(outcome.output, "\n +1 +[0-9]+ +60 +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+ +80 +80 +[-0-9 %]+ +10 +[0-9]+ +[12]\\+[12]\n");
    expectLine(outcome.output, "\n +2 +[0-9]+ +60 .* +10 +10 +- +10 +[0-9]+ +1\\+[12]\n");
    expectLine(outcome.output, "\nworld 1, last frame: 80 bodies, [0-9]+ contacts, 2 threads at most; it has ended\n");
    expectLine(outcome.output, "  collide  [0-9.]+ ms: broad phase [0-9.]+, near-callbacks [0-9.]+");
    expectLine(outcome.output, "  step     [0-9.]+ ms: island search [0-9.]+, .*islands [0-9.]+");
    expectWords(outcome.output, "begins, file /dev/shm/odemt_top_");
    EXPECT_EQ(count(outcome.output, "odemt_top: "), 1u);
    EXPECT_TRUE(std::filesystem::is_empty(folder)) << "nothing is left";
}

TEST_F(OdemtTop, TheFileIsGoneAfterwards) {
    const Outcome outcome = run("--once", STEPPER " 1 1");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(outcome.output, found, std::regex("file (/dev/shm/[^\n]+)\n"))) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(found[1].str()));
}

TEST_F(OdemtTop, ATableForEachInterval) {
    const Outcome outcome = runShell(ODEMT_TOP " --interval 0.1 --threads 0 --output " + output +
                                     " -- " STEPPER " 1 0 & top=$!; sleep 0.8; kill -INT $top; wait $top");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_GE(count(outcome.output, "world  process"), 3u) << outcome.output;
    expectWords(outcome.output, "one thread, as the number of threads is 0 or 1");
    expectWords(outcome.output, "Output of the program: " + output);
    EXPECT_EQ(outcome.output.find("begins"), std::string::npos);
    expectWords(read(output), "begins");
    expectWords(read(output), "ends with");
}

TEST_F(OdemtTop, SIGQUITLeavesNothing) {
    const Outcome outcome = runShell("ulimit -c 0; " ODEMT_TOP " --once --output " + output + " -- " STEPPER " 1 0 & top=$!; until grep -qs begins " +
                                     output + "; do sleep 0.05; done; kill -QUIT $top; wait $top");
    EXPECT_EQ(outcome.exitCode, 128 + SIGQUIT) << outcome.output;
    expectWords(outcome.output, "all frames on average");
    std::smatch found;
    const std::string text = read(output);
    ASSERT_TRUE(std::regex_search(text, found, std::regex("file (/dev/shm/[^\n]+)\n"))) << text;
    EXPECT_FALSE(std::filesystem::exists(found[1].str()));
    std::filesystem::remove(output);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

// Of a script, which runs them deaf to SIGINT: in its process group, with another parent, in a session of its own, and deaf to SIGTERM, too.
TEST_F(OdemtTop, BackgroundJobsEndWithTheProgramThatIsAskedTo) {
    for (const std::string signal : {"INT", "TERM", "HUP"}) {
        const std::string jobs = folder + "/jobs", kept = " & echo $! >>" + jobs + ";";
        const Outcome outcome =
            runShell(ODEMT_TOP " --once --threads 0 --output " + output + " -- sh -c '" STEPPER " 1 0" + kept + " (sleep 100" + kept +
                     "); setsid sleep 100" + kept + " sh -c \"trap true TERM; sleep 100; sleep 100\"" + kept + " echo all >>" + jobs +
                     "; wait' & top=$!; until grep -qs all " + jobs + "; do sleep 0.05; done; kill -" + signal + " $top; wait $top");
        EXPECT_GT(outcome.exitCode, 128) << outcome.output;
        expectWords(outcome.output, "all frames on average");
        int count = 0;
        std::ifstream stream(jobs);
        for (std::string process; std::getline(stream, process) && process != "all"; ++count)
            EXPECT_FALSE(isRunning(process)) << signal << ' ' << process;
        EXPECT_EQ(count, 4);
        std::filesystem::remove(jobs);
    }
}

TEST_F(OdemtTop, BackgroundJobsOfAProgramThatEndsByItselfGoOn) {
    const Outcome outcome = run("--once --threads 0 --output " + output, "sh -c '" STEPPER " 1 5; sleep 100 & echo $!'");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    const std::string text = read(output), process = text.substr(text.rfind('\n', text.size() - 2) + 1);
    EXPECT_TRUE(isRunning(process)) << text;
    runShell("kill " + std::to_string(std::stol(process)));
}

TEST_F(OdemtTop, EndsAsTheProgramDoes) {
    EXPECT_EQ(run("--once", STEPPER " 1 5 code").exitCode, 7);
    const Outcome killed = run("--once", STEPPER " 1 5 kill");
    EXPECT_EQ(killed.exitCode, 128 + SIGKILL);
    expectLine(killed.output, "\n +1 +[0-9]+ +5 ");
    const Outcome kept = run("--once", STEPPER " 1 5 kept");
    EXPECT_EQ(kept.exitCode, 0);
    expectWords(kept.output, "it has ended");
}

TEST_F(OdemtTop, WhatCannotBeStartedIsReported) {
    const Outcome outcome = run("--once", "/nonexistent/program");
    EXPECT_EQ(outcome.exitCode, 127);
    expectWords(outcome.output, "cannot start /nonexistent/program");
    const Outcome noOde = run("--once", "true");
    EXPECT_EQ(noOde.exitCode, 0);
    expectWords(noOde.output, "No world was seen to be stepped");
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

// What steps worlds and cannot be seen: the text says no more than is known.
TEST_F(OdemtTop, WhatIsNotSeenIsNotDenied) {
    for (const std::string program : {"env -i " STEPPER " 1 3", "env LD_PRELOAD=" DEBIANS_LIBRARY " " STEPPER " 1 3"}) {
        const Outcome outcome = run("--once", program);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
        expectWords(outcome.output, "ends with 0 bytes read");
        expectWords(outcome.output, "No world was seen to be stepped. Not seen are programs that take another library");
        expectWords(outcome.output, "LD_PRELOAD");
        expectWords(outcome.output, "env -i");
    }
    expectLine(run("--once", "env LD_PRELOAD=" OUR_LIBRARY " " STEPPER " 1 3").output, "\n +1 +[0-9]+ +3 ");
}

TEST_F(OdemtTop, WrongOptionsAreRefused) {
    EXPECT_EQ(runShell(ODEMT_TOP).exitCode, 2);
    for (const std::string options : {"--threads many", "--threads 1025", "--interval 0", "--our-library /nonexistent", "--unknown"}) {
        const Outcome outcome = run(options, "true");
        EXPECT_EQ(outcome.exitCode, 2) << options << outcome.output;
    }
    EXPECT_EQ(runShell(ODEMT_TOP " --help").exitCode, 0);
}

TEST_F(OdemtTop, StandardInputIsTheProgramsOwn) {
    const Outcome outcome = runShell("printf 1234567 | " ODEMT_TOP " --once -- " STEPPER " 1 5 reader");
    expectWords(outcome.output, "ends with 7 bytes read");
}

TEST_F(OdemtTop, MoreWorldsThanThereIsRoomFor) {
    const Outcome outcome = run("--once --threads 0", STEPPER " 300 2");
    EXPECT_EQ(outcome.exitCode, 0);
    expectWords(outcome.output, "44 further worlds are not shown\n");
}

TEST_F(OdemtTop, SeveralProcesses) {
    const Outcome outcome = run("--once --threads 0", "sh -c '" STEPPER " 1 4 & " STEPPER " 2 5; wait'");
    EXPECT_EQ(outcome.exitCode, 0);
    expectLine(outcome.output, "\n +1 +[0-9]+ +4 ");
    expectLine(outcome.output, "\n +1 +[0-9]+ +5 ");
    expectLine(outcome.output, "\n +2 +[0-9]+ +5 ");
}

// The program does not notice: it makes all of its frames.
TEST_F(OdemtTop, AProgramOutlivesItsViewer) {
    const Outcome outcome = runShell(ODEMT_TOP " --once --output " + output + " -- " STEPPER " 1 1500 & top=$!; while ! grep -qs begins " + output +
                                     "; do sleep 0.02; done; kill -KILL $top; wait $top");
    EXPECT_EQ(outcome.exitCode, 128 + SIGKILL);
    EXPECT_TRUE(hasWords(output, "ends with 0 bytes read")) << read(output);
    std::smatch found;
    const std::string text = read(output);
    if (std::regex_search(text, found, std::regex("file (/dev/shm/[^\n]+)\n"))) std::filesystem::remove(found[1].str());
}

TEST_F(OdemtTop, AProgramOutlivesTheReaderOfTheTables) {
    const Outcome outcome = runShell(ODEMT_TOP " --interval 0.05 --output " + output + " -- " STEPPER " 1 800 | head -1");
    expectWords(outcome.output, "odemt_top: ");
    EXPECT_TRUE(hasWords(output, "ends with 0 bytes read")) << read(output);
}

// `script` gives it a terminal.
TEST_F(OdemtTop, ATerminalIsWrittenOverUntilAKeyEndsTheProgram) {
    const Outcome outcome = runShell("(sleep 0.8; printf q; sleep 0.5) | TERM=xterm COLUMNS=130 LINES=40 script -qec '" ODEMT_TOP
                                     " --interval 0.2 --threads 0 -- " STEPPER " 1 0' /dev/null");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    expectWords(outcome.output, "\x1b[?1049h");
    expectWords(outcome.output, "(q: end it)");
    expectWords(outcome.output, "world 1, last frame");
    expectWords(outcome.output, "Output of the program (" + folder + "/odemt_top_");
    const std::size_t end = outcome.output.find("\x1b[?1049l");
    ASSERT_NE(end, std::string::npos) << "the terminal is as it was before";
    expectWords(outcome.output.substr(end), "all frames on average");
}

TEST_F(OdemtTop, ATerminalThatIsTooSimpleIsReported) {
    const Outcome outcome =
        runShell("TERM=nonsense script -qec '" ODEMT_TOP " -- sh -c \"echo \\$\\$ >" + output + "; exec " STEPPER " 1 0\"' /dev/null");
    EXPECT_NE(outcome.exitCode, 0);
    expectWords(outcome.output, "--batch prints tables");
    if (const std::string process = read(output); !process.empty()) {
        EXPECT_FALSE(isRunning(process)) << "it was not watched";
    }
}

}  // namespace
