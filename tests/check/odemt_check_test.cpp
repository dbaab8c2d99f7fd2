// odemt_check as users call it: its verdict on programs that are the same on both libraries, and on others that are not, or that
// cannot be compared. subject.c says what each mode does.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "../bench/shell_run.h"
#include "platform.h"

namespace {

using Json = nlohmann::json;

const std::string kSubject = SUBJECT;

// Compared with the library that ours has the bits of, which need not be this system's own, unless the options name another.
Outcome check(const std::string &options, const std::string &program) {
    const bool isNamed = options.find("--stock-library") != std::string::npos;
    return runShell(ODEMT_CHECK + std::string(isNamed ? " " : " --stock-library " STOCK_FOLDER " ") + options + " -- " + program);
}

// One run on ODE_MT, unless the options say otherwise.
Json checkJson(const std::string &program, int exitCode, const std::string &options = "--threads 2") {
    const Outcome outcome = check("--json " + options, program);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.output;
    const Json json = Json::parse(outcome.output, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << outcome.output;
    return json.is_discarded()
               ? Json{{"sentence", ""}, {"remarks", Json::array()}, {"difference", nullptr}, {"engines", Json::array()}}
               : json;
}

void expectWords(const std::string &text, const std::string &words) {
    EXPECT_NE(text.find(words), std::string::npos) << text << "\nhas not: " << words;
}

class OdemtCheck : public testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(m_runs); }

    const std::string m_runs = testing::TempDir() + "odemt_check_runs_" + std::to_string(getpid());
};

TEST_F(OdemtCheck, APlainProgramIsEqual) {
    const Json json = checkJson(kSubject + " equal", 0, "--threads 0,1,2,auto");
    EXPECT_EQ(json["verdict"], "equal");
    EXPECT_EQ(json["steps"], 60);
    EXPECT_EQ(json["worlds"], 1);
    EXPECT_EQ(json["bodies"], 8);
    ASSERT_EQ(json["engines"].size(), 5u);
    for (const Json &engine : json["engines"]) EXPECT_EQ(engine["steps"], 60);
    EXPECT_EQ(json["engines"][0]["library"], std::filesystem::canonical(STOCK_LIBRARY).string());
    EXPECT_EQ(json["engines"][4]["library"], std::filesystem::canonical(OUR_FOLDER "/libode.so.8").string());
    EXPECT_GT(json["engines"][4]["seconds"], json["engines"][4]["stepSeconds"]);
    EXPECT_GT(json["engines"][4]["stepSeconds"], 0);
    EXPECT_GT(json["engines"][4]["cpuSeconds"], 0);
}

TEST_F(OdemtCheck, TheTextSaysSo) {
    const Outcome outcome = check("", kSubject);
    EXPECT_EQ(outcome.exitCode, 0);
    expectWords(outcome.output, "Equal for 60 steps: the states of 8 bodies in 1 world are the same in every bit.");
    expectWords(outcome.output, "ODE_MT, all cores");
}

TEST_F(OdemtCheck, LibrariesOfOneReleaseNeedNoRemark) {
    const Json json = checkJson(kSubject + " equal", 0);
    for (const Json &engine : json["engines"]) EXPECT_EQ(engine["release"], UPSTREAM);
    EXPECT_EQ(json["remarks"].dump().find("release"), std::string::npos) << json["remarks"];
}

// A copy under the name of another release stands in for that release.
TEST_F(OdemtCheck, ReleasesThatDifferAreSaidTo) {
    const std::string folder = testing::TempDir() + "/odemt_check_release_" + std::to_string(getpid());
    const std::string number = std::string(UPSTREAM) == "0.16.2" ? "8.2.0" : "8.0.2";
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(STOCK_LIBRARY, folder + "/libode.so." + number);
    std::filesystem::create_symlink("libode.so." + number, folder + "/libode.so.8");
    const std::string release = bench::releaseOfLibrary(folder + "/libode.so.8"), options = "--threads 2 --stock-library " + folder;
    const std::string remark =
        "libode8 here is ODE " + release + ", ours is made of " UPSTREAM ": results may differ, since the releases do (docs/tools.md).";
    const Json json = checkJson(kSubject + " equal", 0, options);
    ASSERT_EQ(json["remarks"].size(), 1u) << json["remarks"];
    EXPECT_EQ(json["remarks"][0], remark);
    EXPECT_EQ(json["engines"][0]["release"], release);
    EXPECT_EQ(json["engines"][1]["release"], UPSTREAM);
    expectWords(check(options, kSubject).output, '\n' + remark + '\n');
    expectWords(check(options, kSubject + " no-steps").output, remark);
    std::filesystem::remove_all(folder);
}

TEST_F(OdemtCheck, TheFirstStepBodyAndFieldThatDifferAreNamed) {
    const Json json = checkJson(kSubject + " push", 1), &difference = json["difference"];
    EXPECT_EQ(json["verdict"], "different");
    EXPECT_EQ(json["steps"], 36);
    ASSERT_TRUE(difference.is_object()) << json;
    EXPECT_EQ(difference["engine"], "ODE_MT, 2 threads");
    EXPECT_EQ(difference["step"], 37);
    EXPECT_EQ(difference["world"], "world 0");
    ASSERT_TRUE(difference.contains("values")) << json;
    EXPECT_EQ(difference["values"][0]["body"], 5);
    EXPECT_EQ(difference["values"][0]["field"], "position x");
    EXPECT_NE(difference["values"][0]["libode8"], difference["values"][0]["other"]);

    const Outcome outcome = check("--threads 0", kSubject + " push");
    EXPECT_EQ(outcome.exitCode, 1);
    expectWords(outcome.output,
                "Different on ODE_MT, 0 threads: world 0 differs at step 37 for the first time, in position x of body 5. Equal "
                "before: 36 steps.");
    expectWords(outcome.output, "body 5, linear velocity x");
}

// By then more bodies have been destroyed than are there.
TEST_F(OdemtCheck, BodiesKeepTheirNumbers) {
    const Json json = checkJson(kSubject + " push-late", 1), &difference = json["difference"];
    EXPECT_EQ(difference["step"], 57);
    EXPECT_EQ(difference["values"][0]["body"], 5);
    EXPECT_EQ(difference["bodies"], 8);
}

TEST_F(OdemtCheck, EachFieldIsCompared) {
    for (const std::string field :
         {"position x", "quaternion w", "linear velocity y", "angular velocity z", "force x", "torque y"}) {
        const Json json = checkJson(kSubject + " 'field-" + field + "'", 1);
        expectWords(json["sentence"],
                    "world 0 differs at step 6 for the first time, in " + field + " of body 8. Equal before: 5 steps.");
    }
    expectWords(checkJson(kSubject + " field-enabled", 1)["difference"]["values"].dump(), "\"enabled flag\"");
}

TEST_F(OdemtCheck, TheNumberOfThreadsThatDiffersIsNamed) {
    const Json json = checkJson(kSubject + " push-two-threads", 1, "--threads 0,2,1");
    EXPECT_EQ(json["engines"][1]["result"], "equal");
    EXPECT_EQ(json["engines"][2]["result"], "differs at step 37");
    EXPECT_EQ(json["engines"][3]["result"], "equal");
    EXPECT_EQ(json["difference"]["engine"], "ODE_MT, 2 threads");
}

TEST_F(OdemtCheck, ADifferenceThatComesAndGoesIsOne) {
    const Json json = checkJson(kSubject + " push-sometimes " + m_runs, 1);
    EXPECT_EQ(json["difference"]["step"], 21);
    EXPECT_FALSE(json["difference"].contains("values"));
    expectWords(json["remarks"].dump(), "did not differ in the same way, but at step 23");
}

TEST_F(OdemtCheck, AProgramThatIsNotReproducibleIsSaidToBe) {
    const Json json = checkJson(kSubject + " clock", 2);
    EXPECT_EQ(json["verdict"], "not compared");
    expectWords(
        json["sentence"],
        "The program itself is not reproducible: two runs on libode8 differ: world 0 differs at step 1, its first, in step size.");
    EXPECT_EQ(json["difference"]["engine"], "libode8");
    EXPECT_EQ(json["difference"]["values"][0]["field"], "step size");
}

// The first run on ODE_MT does what the third one on libode8 does.
TEST_F(OdemtCheck, WhatRunsOnLibode8DoAtTimesIsNoDifference) {
    const Json json = checkJson(kSubject + " push-by-chance " + m_runs, 2);
    expectWords(json["sentence"], "The program itself is not reproducible: two runs on libode8 differ: world 0 differs at step 1, its first");
}

TEST_F(OdemtCheck, ADifferenceOfOneRunIsCounted) {
    const Json json = checkJson(kSubject + " push-once " + m_runs, 1);
    expectWords(json["remarks"].dump(),
                "1 run of 5 on ODE_MT, 2 threads differed, and none of 5 on libode8: what differs depends on time or chance.");
}

// Worlds are in another process each time, under another number, and messages come in another order.
TEST_F(OdemtCheck, ProcessesOfAPoolMayShareTasksInAnyWay) {
    const Json json = checkJson(kSubject + " pool " + m_runs, 0);
    EXPECT_EQ(json["steps"], 80);
    EXPECT_EQ(json["worlds"], 4);
    expectWords(json["remarks"].dump(), "Standard error differs from line ");
    const Json other = checkJson(kSubject + " pool-differs " + m_runs, 1);
    EXPECT_EQ(other["steps"], 60 + 10);
    EXPECT_EQ(other["difference"]["step"], 11);
    ASSERT_TRUE(other["difference"].contains("values")) << other;
    EXPECT_EQ(other["difference"]["values"][0]["body"], 3);
}

// What a task computes depends on the ones before it in its process.
TEST_F(OdemtCheck, APoolThatIsNotReproducibleIsSaidToBe) {
    const Json json = checkJson(kSubject + " pool-random " + m_runs, 2);
    expectWords(json["sentence"], "The program itself is not reproducible: two runs on libode8 differ: world ");
    const Json once = checkJson(kSubject + " pool-random-once " + (m_runs + "_once"), 2);
    std::filesystem::remove(m_runs + "_once");
    expectWords(once["sentence"], "Not decided: 1 run of 5 on ODE_MT, 2 threads differed, and none of 5 on libode8.");
}

TEST_F(OdemtCheck, AnEndThatIsNotReproducibleIsNone) {
    const Json json = checkJson(kSubject + " more-each-run " + m_runs, 2);
    expectWords(json["sentence"],
                "The program itself is not reproducible: two runs on libode8 differ: world 0 makes 60 steps on libode8, 62 on "
                "libode8 again.");
    expectWords(json["remarks"].dump(), "as far as its run and the first one go: 60 steps.");
}

TEST_F(OdemtCheck, OtherEndsAreDifferences) {
    const Json crash = checkJson(kSubject + " crash", 1);
    expectWords(crash["sentence"], "world 0 makes 60 steps on libode8, 20 on ODE_MT, 2 threads. Equal before: 20 steps.");
    expectWords(crash["remarks"].dump(),
                "libode8 ends with exit code 0, ODE_MT, 2 threads with signal 6 (Aborted), libode8 again with exit code 0, ODE_MT, 2 threads again "
                "with signal 6 (Aborted).");
    expectWords(crash["remarks"].dump(), "last words");
    const Json more = checkJson(kSubject + " more-steps", 1);
    expectWords(more["sentence"], "world 0 makes 60 steps on libode8, 65 on ODE_MT, 2 threads.");
    EXPECT_TRUE(more["remarks"].empty()) << more["remarks"];
    expectWords(checkJson(kSubject + " exit-code", 1)["sentence"], "ODE_MT, 2 threads with exit code 4");
    expectWords(checkJson(kSubject + " message", 1)["sentence"],
                "Messages of ODE differ: 'nothing' (libode8), 'ODE Message 7: a message of ODE's'");
}

TEST_F(OdemtCheck, ACrashThatIsNotReproducibleIsTold) {
    const Json json = checkJson(kSubject + " crash-once " + m_runs, 2);
    expectWords(json["sentence"], "world 0 makes 20 steps on libode8, 60 on libode8 again.");
    expectWords(json["remarks"].dump(),
                "libode8 ends with signal 6 (Aborted), ODE_MT, 2 threads with exit code 0, libode8 again with exit code 0.");
    expectWords(json["remarks"].dump(), "libode8 says at the end: last words");
}

TEST_F(OdemtCheck, TheSameCrashOnBothIsEqual) {
    const Json json = checkJson(kSubject + " crash-everywhere", 0);
    EXPECT_EQ(json["steps"], 20);
    expectWords(json["remarks"].dump(), "ends with signal 6 (Aborted), on both libraries");
}

TEST_F(OdemtCheck, OtherOutputIsToldAndNoDifference) {
    const Json json = checkJson(kSubject + " output", 0);
    expectWords(json["remarks"].dump(),
                "Standard output differs from line 1 on: 'libode8' (libode8), 'ODE_MT' (ODE_MT, 2 threads)");
    const Outcome shown = check("--show-output --threads 0", kSubject + " output");
    expectWords(shown.output, "libode8\nODE_MT\n");
}

TEST_F(OdemtCheck, WorldsOfTwoThreadsMayBeMadeInAnyOrder) {
    const Json json = checkJson(kSubject + " threads " + m_runs, 0);
    EXPECT_EQ(json["steps"], 120);
    EXPECT_EQ(json["worlds"], 2);
    const Json other = checkJson(kSubject + " threads-differ " + m_runs, 1);
    EXPECT_EQ(other["steps"], 60 + 29);
    EXPECT_EQ(other["difference"]["step"], 30);
    ASSERT_TRUE(other["difference"].contains("values")) << other;
    EXPECT_EQ(other["difference"]["values"][0]["body"], 1);
}

// Of one thread's worlds each has its number.
TEST_F(OdemtCheck, WorldsThatHaveExchangedEverythingDiffer) {
    const Json json = checkJson(kSubject + " exchange", 1);
    EXPECT_EQ(json["steps"], 0);
    EXPECT_EQ(json["difference"]["step"], 1);
    EXPECT_EQ(json["difference"]["world"], "world 0");
    expectWords(json["remarks"].dump(), "exchanged");
}

TEST_F(OdemtCheck, ProcessesThatForkHaveARecordEach) {
    const Json json = checkJson(kSubject + " fork", 0);
    EXPECT_EQ(json["steps"], 60 + 20 + 15);
    EXPECT_EQ(json["worlds"], 3);
    const Json other = checkJson(kSubject + " fork-differs", 1), &difference = other["difference"];
    EXPECT_EQ(difference["step"], 11);
    expectWords(difference["world"], "world 0 of process 1");
    EXPECT_EQ(difference["values"][0]["body"], 3);
}

TEST_F(OdemtCheck, ProgramsThatAProgramStartsAreObserved) {
    EXPECT_EQ(checkJson("sh -c '" + kSubject + " equal; " + kSubject + " equal'", 0)["steps"], 120);
    expectWords(checkJson("sh -c '" + kSubject + " equal; " + kSubject + " push'", 1)["difference"]["world"],
                "world 0 of process 1");
}

TEST_F(OdemtCheck, FunctionsThatAreLookedUpByNameAreObserved) {
    EXPECT_EQ(checkJson(LOADS_ODE " libode.so.8", 0)["steps"], 10);
    const Json json = checkJson(LOADS_ODE " libode.so.8 differ", 1);
    EXPECT_EQ(json["difference"]["step"], 7);
    EXPECT_EQ(json["difference"]["values"][0]["field"], "position x");
}

TEST_F(OdemtCheck, DebiansPythonBindingIsObserved) {
    if (std::system("cd / && /usr/bin/python3 -c 'import ode; ode.World()' 2>/dev/null") != 0)
        GTEST_SKIP() << "python3-pyode is not installed";
    const Json json = checkJson("/usr/bin/python3 " EXAMPLES "/pendulums.py", 0);
    EXPECT_EQ(json["steps"], 100);
    EXPECT_EQ(json["bodies"], 500);
}

// It looks dWorldStep up behind itself: not behind the observer, where it would find itself.
TEST_F(OdemtCheck, OtherLibrariesInFrontOfOdeStayThere) {
    const Outcome outcome =
        runShell("LD_PRELOAD=" COUNTS_STEPS " " ODEMT_CHECK " --stock-library " STOCK_FOLDER " --threads 0 --show-output -- " SUBJECT);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    expectWords(outcome.output, "counted 30\ncounted 30\n");
    expectWords(outcome.output, "Equal for 60 steps");
}

TEST_F(OdemtCheck, StandardInputIsGivenToAllRuns) {
    const Outcome outcome = runShell("echo 25 | " ODEMT_CHECK " --stock-library " STOCK_FOLDER " --threads 0 -- " SUBJECT " input");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    expectWords(outcome.output, "Equal for 25 steps");
    // More than fits into a pipe, of which no run reads anything.
    EXPECT_EQ(runShell("head -c 1000000 /dev/zero | " ODEMT_CHECK " --stock-library " STOCK_FOLDER " --threads 0 -- " SUBJECT).exitCode, 0);
}

TEST_F(OdemtCheck, ProgramsWithoutAnEndAreEnded) {
    EXPECT_EQ(checkJson(kSubject + " endless", 0, "--threads 2 --steps 20")["steps"], 20);
    const Json json = checkJson(kSubject + " endless", 0, "--threads 2 --seconds 2");
    EXPECT_GT(json["steps"], 5);
    EXPECT_EQ(checkJson(kSubject + " slow-on-libode8", 0, "--threads 2 --seconds 5")["steps"], 30);
    EXPECT_EQ(checkJson(kSubject + " push", 1, "--threads 2 --steps 40")["difference"]["step"], 37);
    EXPECT_EQ(checkJson(kSubject + " push", 0, "--threads 2 --steps 36")["steps"], 36);
    EXPECT_EQ(checkJson(kSubject + " more-steps", 1, "--threads 2 --steps 62")["verdict"], "different");
}

TEST_F(OdemtCheck, AHangOnOneLibraryIsADifference) {
    const Json json = checkJson(kSubject + " hang", 1, "--threads 2 --seconds 5");
    expectWords(json["sentence"], "libode8 ends after ");
    expectWords(json["sentence"], "ODE_MT, 2 threads had not ended after ");
}

TEST_F(OdemtCheck, AnInterruptGivesWhatWasComparedByThen) {
    const Json json = checkJson(kSubject + " interrupt", 2);
    expectWords(json["sentence"], "Interrupted: equal for the ");
    EXPECT_GE(json["steps"], 30);
}

TEST_F(OdemtCheck, ProgramsThatCannotBeComparedAreToldWhy) {
    const auto expect = [](const std::string &program, const std::string &words, const std::string &options = "--threads 0") {
        expectWords(checkJson(program, 2, options)["sentence"], words);
    };
    expect(NO_ODE, "No process of '" NO_ODE "' was seen to use libode.so.8");
    expect(STATIC_PROGRAM, "'" STATIC_PROGRAM "' is statically linked");
    expect(SUBJECT_COPY, "'" SUBJECT_COPY "' has a copy of ODE inside");
    expect(SUBJECT_RPATH, "and uses '" + std::filesystem::canonical(STOCK_LIBRARY).string() + "' all the same");
    expect(LOADS_ODE " " STOCK_LIBRARY, "or loads this one by its path");
    expect(kSubject + " no-steps", "makes worlds of ODE, but steps none");
    expect(LOADS_ODE " libode.so.8", "has single precision", "--threads 0 --stock-library " SINGLE_FOLDER);
}

// A program that steps worlds all the same is told no untruth.
TEST_F(OdemtCheck, WhatCannotBeSeenIsNotDenied) {
    const std::string sentence = checkJson("env -i " + kSubject + " equal", 2, "--threads 0")["sentence"];
    expectWords(sentence,
                "No process of 'env' was seen to use libode.so.8. Not seen are those that are started with an emptied environment (env -i)");
}

TEST_F(OdemtCheck, AnotherLibraryByLD_PRELOADIsNamed) {
    const std::string library = std::filesystem::canonical(OUR_FOLDER "/libode.so.8"), copy = m_runs + "_mine.so";
    const auto sentenceWith = [](const std::string &preloaded) {
        setenv("LD_PRELOAD", preloaded.c_str(), 1);
        const std::string sentence = checkJson(kSubject + " equal", 2, "--threads 0")["sentence"];
        unsetenv("LD_PRELOAD");
        return sentence;
    };
    expectWords(sentenceWith(library), "and uses '" + library + "' all the same: LD_PRELOAD names it.");
    std::filesystem::copy_file(library, copy);
    expectWords(sentenceWith(copy), "uses '" + copy + "': ODE under another name");
    std::filesystem::remove(copy);
}

// Of the system's: no bytes, no files, and room for the first record alone.
TEST_F(OdemtCheck, AFullTemporaryFolderIsNamed) {
    if (runShell("unshare --mount true").exitCode != 0) GTEST_SKIP() << "no file system can be mounted here";
    const std::string folder = testing::TempDir() + "/odemt_check_full_" + std::to_string(getpid());
    std::filesystem::create_directory(folder);
    for (const std::string &fill :
         {"size=64k tmpfs " + folder + " && head -c 1M /dev/zero >" + folder + "/filled",
          "size=64k tmpfs " + folder + " && head -c 48k /dev/zero >" + folder + "/filled", "size=1m,nr_inodes=8 tmpfs " + folder + " && true"}) {
        const Outcome outcome = runShell("unshare --mount sh -c 'mount -t tmpfs -o " + fill + "; TMPDIR=" + folder +
                                         " " ODEMT_CHECK " --stock-library " STOCK_FOLDER " --threads 0 -- " SUBJECT " equal'");
        EXPECT_EQ(outcome.exitCode, 2) << outcome.output;
        EXPECT_TRUE(outcome.output.find("no room for records in '" + folder) != std::string::npos ||
                    outcome.output.find("there is no room in '" + folder) != std::string::npos)
            << fill << '\n'
            << outcome.output;
        EXPECT_EQ(outcome.output.find("No process"), std::string::npos) << outcome.output;
    }
    std::filesystem::remove(folder);
}

TEST_F(OdemtCheck, WrongOptionsAreNamed) {
    const auto expect = [](const std::string &arguments, const std::string &words) {
        const Outcome outcome = runShell(ODEMT_CHECK " " + arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments << ": " << outcome.output;
        expectWords(outcome.output, words);
    };
    expect("", "no program given");
    expect("--", "no program given");
    expect(kSubject, "Run with --help");
    expect("--threads 0,x -- " + kSubject, "--threads: 'x' is neither a number from 0 to 1024 nor auto");
    expect("--threads 1025 -- " + kSubject, "'1025'");
    expect("--steps 0 -- " + kSubject, "--steps");
    expect("--stock-library /nowhere -- " + kSubject, "--stock-library: no libode.so.8 in '/nowhere'");
    expect("--stock-library " OUR_FOLDER " -- " + kSubject, "is ODE_MT");
    expect("--our-library $(dirname " STOCK_LIBRARY ") -- " + kSubject, "is not ODE_MT");
    expect("-- /nowhere/program", "cannot start /nowhere/program: No such file or directory");
}

TEST_F(OdemtCheck, WhatAProgramLeavesRunningIsEnded) {
    const std::string kept = " & echo $! >>" + m_runs + ";";
    // In the program's process group, in a session of its own, there with another parent, and deaf to SIGTERM.
    const Outcome outcome = check("--threads 0", "sh -c 'sleep 100" + kept + " setsid sleep 100" + kept + " (setsid sleep 100" + kept +
                                                     "); setsid sh -c \"trap true TERM; sleep 100; sleep 100\"" + kept + " exec " + kSubject + "'");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    std::ifstream stream(m_runs);
    int count = 0;
    for (std::string process; std::getline(stream, process); ++count)
        EXPECT_NE(runShell("kill -0 " + process + " && ! grep -q '^State:.Z' /proc/" + process + "/status").exitCode, 0) << process;
    EXPECT_EQ(count, 8);
}

TEST_F(OdemtCheck, NothingIsLeftBehindBySIGQUIT) {
    const std::string folder = testing::TempDir() + "/odemt_check_quit_" + std::to_string(getpid());
    std::filesystem::create_directory(folder);
    const Outcome outcome =
        runShell("TMPDIR=" + folder + " " ODEMT_CHECK " --stock-library " STOCK_FOLDER " --threads 0 -- " SUBJECT " endless & check=$!; until ls " +
                 folder + "/odemt_check_*/run-1/record-0000 2>/dev/null; do sleep 0.05; done; kill -QUIT $check; wait $check");
    EXPECT_EQ(outcome.exitCode, 2) << outcome.output;
    expectWords(outcome.output, "Interrupted during the first run");
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
}

TEST_F(OdemtCheck, NothingIsLeftBehind) {
    const std::string folder = testing::TempDir() + "/odemt_check_temporary_" + std::to_string(getpid());
    std::filesystem::create_directory(folder);
    EXPECT_EQ(runShell("TMPDIR=" + folder + " " ODEMT_CHECK " --stock-library " STOCK_FOLDER " --threads 0 -- " SUBJECT " push").exitCode, 1);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
}

}  // namespace
