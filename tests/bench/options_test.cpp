#include "options.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

using namespace bench;

namespace {

struct Outcome {
    std::optional<Options> options;
    int exitCode = 0;
    std::string output, errors;
};

Outcome read(std::vector<const char *> arguments) {
    arguments.insert(arguments.begin(), "odemt_bench");
    Outcome outcome;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    outcome.options = readOptions(static_cast<int>(arguments.size()), arguments.data(), outcome.exitCode);
    outcome.output = testing::internal::GetCapturedStdout();
    outcome.errors = testing::internal::GetCapturedStderr();
    return outcome;
}

void expectComplaint(const std::vector<const char *> &arguments, const std::string &word) {
    const Outcome outcome = read(arguments);
    EXPECT_FALSE(outcome.options);
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.errors.find(word), std::string::npos) << outcome.errors;
}

}  // namespace

TEST(Options, AreRead) {
    const Outcome outcome =
        read({"--worlds", "rover,stacks:3,sap", "--engines", "stock,ours", "--threads", "0,2", "--seconds",
              "1.5", "--frames", "77", "--json", "a.json", "--warm-up-seconds", "9.5"});
    ASSERT_TRUE(outcome.options) << outcome.errors;
    EXPECT_EQ(outcome.options->worlds, (std::vector<std::string>{"rover", "stacks:3,sap"}));
    EXPECT_EQ(outcome.options->engines.size(), 3u);
    EXPECT_DOUBLE_EQ(outcome.options->race.stop.maximumSeconds, 1.5);
    EXPECT_EQ(outcome.options->race.stop.maximumFrames, 77);
    EXPECT_DOUBLE_EQ(outcome.options->race.warmUpSeconds, 9.5);
    EXPECT_EQ(outcome.options->jsonFile, "a.json");
    EXPECT_EQ(outcome.options->samplesFile, "");
    EXPECT_EQ(outcome.options->race.stop.minimumSeconds, 0);
    EXPECT_TRUE(outcome.options->withAverages);
}

TEST(Options, ARangeOfSizesIsSeveralWorlds) {
    const Outcome outcome = read({"--worlds", "stacks:2..9,sap", "--engines", "ours:0"});
    ASSERT_TRUE(outcome.options) << outcome.errors;
    EXPECT_EQ(outcome.options->worlds,
              (std::vector<std::string>{"stacks:2,sap", "stacks:4,sap", "stacks:8,sap"}));
    expectComplaint({"--worlds", "stacks:9..2"}, "'9..2'");
}

TEST(Options, QuickIsADefaultAndNothingMore) {
    const Outcome quick = read({"--quick"});
    ASSERT_TRUE(quick.options) << quick.errors;
    EXPECT_EQ(quick.options->worlds.size(), 4u);
    EXPECT_EQ(quick.options->engines.size(), 2u);
    EXPECT_LE(static_cast<double>(quick.options->worlds.size()) * quick.options->race.stop.maximumSeconds, 20);
    const Outcome set = read({"--quick", "--seconds", "9", "--threads", "1,2"});
    ASSERT_TRUE(set.options) << set.errors;
    EXPECT_EQ(set.options->engines.size(), 3u);
    EXPECT_EQ(set.options->race.stop.maximumSeconds, 9);
}

TEST(Options, TwoFilesAreCompared) {
    EXPECT_EQ(read({"--compare", "/dev/null", "/dev/zero"}).options->compared, (std::vector<std::string>{"/dev/null", "/dev/zero"}));
    expectComplaint({"--compare", "/dev/null"}, "--compare");
    expectComplaint({"--compare", "/dev/null", "/none"}, "/none");
}

TEST(Options, ATraceHasAFileOfItsOwn) {
    const Outcome outcome = read({"--worlds", "rover", "--engines", "ours:0", "--trace", "t.json"});
    ASSERT_TRUE(outcome.options) << outcome.errors;
    EXPECT_EQ(outcome.options->traceFile, "t.json");
    expectComplaint({"--worlds", "rover", "--engines", "ours:0", "--json", "X", "--trace", "X"}, "X");
}

TEST(Options, OtherLibrariesAreEngines) {
    const Outcome outcome = read({"--worlds", "rover", "--engines", "stock,stock:" ODEMT_ORACLE ",stock:" ODEMT_STOCK_FOLDER ",ours:2"});
    ASSERT_TRUE(outcome.options) << outcome.errors;
    EXPECT_EQ(outcome.options->engines.size(), 4u);
    EXPECT_EQ(outcome.options->engines[1].path, ODEMT_ORACLE);
}

TEST(Options, LibrariesThatAreMissingOrOursAreNamed) {
    expectComplaint({"--worlds", "rover", "--engines", "stock:/nowhere/libode.so.8"}, "no such file: '/nowhere/libode.so.8'");
    expectComplaint({"--worlds", "rover", "--engines", "stock:/a\\,b"}, "no such file: '/a,b'");
    expectComplaint({"--worlds", "rover", "--engines", "stock:/proc"}, "no such file: '/proc/libode.so.8'");
    expectComplaint({"--worlds", "rover", "--engines", "stock:/dev/null"}, "no such file: '/dev/null'");
    expectComplaint({"--worlds", "rover", "--engines", "stock:"}, "no path of a libode.so.8");
    expectComplaint({"--worlds", "rover", "--engines", "stock:" ODEMT_OUR_FOLDER}, "is ODE_MT itself");
    expectComplaint({"--worlds", "rover", "--engines", "stock", "--stock-library", ODEMT_OUR_FOLDER}, "is ODE_MT itself");
    expectComplaint({"--worlds", "rover", "--engines", "stock-pool:2", "--stock-library", ODEMT_OUR_FOLDER}, "apt-get download libode8");
}

// By a link in the place of the system's, and before all libraries.
TEST(Options, OursInThePlaceOfTheSystemsIsNamed) {
    const std::string folder = testing::TempDir() + "/options_" + std::to_string(getpid());
    std::filesystem::create_directories(folder);
    std::filesystem::create_symlink(std::filesystem::canonical(ODEMT_OUR_FOLDER "/libode.so.8"), folder + "/libode.so.8");
    expectComplaint({"--worlds", "rover", "--engines", "stock,ours:2", "--stock-library", folder.c_str()}, "it would be measured against itself");
    setenv("LD_PRELOAD", (ODEMT_ORACLE " " + folder + "/libode.so.8").c_str(), 1);
    expectComplaint({"--worlds", "rover", "--engines", "stock,ours:2"}, "LD_PRELOAD: '" + folder + "/libode.so.8' is ODE_MT itself");
    setenv("LD_PRELOAD", "/nowhere/lib.so", 1);
    EXPECT_TRUE(read({"--worlds", "rover", "--engines", "stock,ours:2"}).options);
    unsetenv("LD_PRELOAD");
    std::filesystem::remove_all(folder);
}

TEST(Options, WithSamplesMeasuringDoesNotEndEarly) {
    const Outcome outcome = read(
        {"--worlds", "rover", "--engines", "stock", "--seconds", "7", "--samples", "s.csv", "--no-averages"});
    ASSERT_TRUE(outcome.options) << outcome.errors;
    EXPECT_EQ(outcome.options->samplesFile, "s.csv");
    EXPECT_DOUBLE_EQ(outcome.options->race.stop.minimumSeconds, 7);
    EXPECT_FALSE(outcome.options->withAverages);
}

TEST(Options, WrongOnesAreAnsweredByName) {
    expectComplaint({"--wurlds", "rover"}, "--wurlds");
    expectComplaint({"--worlds", "moon"}, "'moon'");
    expectComplaint({"--worlds", "rover", "--engines", "bullet"}, "'bullet'");
    expectComplaint({"--worlds", "rover", "--threads", "lots"}, "'lots'");
    expectComplaint({"--worlds", "rover", "--engines", "stock,ours:0", "--threads", "lots"}, "'lots'");
    expectComplaint({"--worlds", "rover", "--engines", "stock,ours:0", "--threads", "2,1025"}, "1025");
    expectComplaint({"--worlds", "rover", "--engines", "ours:1/cells=3"}, "'3'");
    expectComplaint({"--worlds", "rover", "--samples"}, "--samples");
    expectComplaint({"--worlds", "rover", "--manager", "tbb"}, "'tbb'");
    expectComplaint({"--worlds", "rover", "--seconds", "-1"}, "--seconds");
    expectComplaint({"--worlds", "rover", "--frames", "0"}, "--frames");
    expectComplaint({"--worlds", "rover", "--warm-up-seconds", "0"}, "--warm-up-seconds");
    expectComplaint({"--worlds", "rover", "--our-library", "/nowhere"}, "--our-library");
    expectComplaint({"--worlds", ""}, "--worlds");
    expectComplaint({"--worlds", "thesis,hash"}, "a modifier belongs to one world");
    expectComplaint({"--worlds", "rover,hash,hash"}, "'hash' is said twice");
    expectComplaint({"--worlds", "rover,hash,sap"}, "'hash' and 'sap' exclude one another");
    expectComplaint({"--worlds", "rover,world,quick"}, "'world' and 'quick' exclude one another");
    expectComplaint({"--worlds", "pioneer3at:"}, "no size behind the colon");
    expectComplaint({"--worlds", "pioneer3at:010"}, "'010'");
    expectComplaint({"--worlds", "rover:010"}, "'010'");
    expectComplaint({"--worlds", "rover", "--json", ""}, "no name");
}

TEST(Options, HelpExplainsEnginesAndGivesExamples) {
    const Outcome outcome = read({"--help"});
    EXPECT_FALSE(outcome.options);
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char *word : {"stock-pool:N", "ours:N", "Examples:", "--worlds", "1000..32000", "exit code"})
        EXPECT_NE(outcome.output.find(word), std::string::npos) << word;
}

TEST(Options, NumbersOutOfRangeAreAnsweredWithTheRange) {
    for (const char *option : {"--seconds", "--warm-up-seconds", "--timeout"})
        for (const char *value : {"nan", "inf", "1e308", "1e999", "-1", "0", "1x", " 1", ""})
            expectComplaint({option, value}, "is not a number from 0.001 to 1000000\n");
    for (const char *value : {"nan", "2", "1e308"})
        expectComplaint({"--tolerance", value}, "is not a number from 1e-06 to 1\n");
    for (const char *value : {"0", "1.5", "99999999999999999999", "nan", "010"})
        expectComplaint({"--frames", value}, "is not a whole number from 1 to 1000000000\n");
}

TEST(Options, OneFileForTwoKindsOfResultsIsRefused) {
    expectComplaint({"--worlds", "rover:3", "--engines", "ours:0", "--json", "X", "--csv", "./X"},
                    "are one file");
    expectComplaint(
        {"--worlds", "rover:3", "--engines", "ours:0", "--json", "X", "--samples", "nowhere/../X"},
        "are one file");
}
