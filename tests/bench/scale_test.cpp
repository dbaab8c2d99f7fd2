// The model of docs/remote.md: steps that can be reckoned by hand, what must hold for any cluster, and a recorded scenario.
#include "scale/measured_world.h"
#include "scale/scale_table.h"
#include "scale/step_simulation.h"

#include <unistd.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "shell_run.h"
#include "slow_world.h"

namespace {

using namespace scale;

constexpr double kMs = 1e6, kUs = 1e3;

// Islands of equal cost: ten milliseconds at home, of which one is home's part if they go out.
MeasuredWorld equalIslands(std::size_t count, double bytes = 100e3) {
    MeasuredWorld measured;
    measured.world = "equal";
    const double islands = static_cast<double>(count);
    measured.homeFrameNs = islands * 10 * kMs + 5 * kMs;
    measured.homeStepNs = islands * 10 * kMs;
    measured.awayStepNs = islands * 1 * kMs;
    measured.latencyNs = 100 * kUs;
    measured.nsPerByte = 0.5;
    measured.steps.assign(3, Step(count, Problem{36, 200, bytes, 5000, 9 * kMs}));
    return measured;
}

double frameMs(const MeasuredWorld &measured, unsigned workers, const char *network, bool sendsAll = false) {
    return predictFrame(measured, {workers, readNetwork(network), sendsAll, true, 0}) / kMs;
}

std::string read(const std::string &file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

// One message there and back: home's part, two delays, the wire, the solver, and less than half a millisecond of software.
TEST(Scale, OneIslandThatGoesOutTakesWhatItsMessagesTake) {
    const double atHome = 1, rest = 5, delays = 2 * 10, wire = 105e3 / 1e8 * 1e3, solver = 9;
    const double frame = frameMs(equalIslands(1), 1, "1e7/1e8", true), expected = rest + atHome + delays + wire + solver;
    EXPECT_GT(frame, expected);
    EXPECT_LT(frame, expected + 0.5);
}

// Ten islands on a slow wire: it is busy all the time.
TEST(Scale, ASlowWireIsWhatAllWaitFor) {
    const double wire = 10 * 100e3 / 1e6 * 1e3;
    const double frame = frameMs(equalIslands(10), 4, "0/1e6", true);
    EXPECT_GT(frame, wire);
    EXPECT_LT(frame, wire + 5 + 2 + 9 + 10);
}

TEST(Scale, TwoWorkersTakeHalfTheTimeOfOne) {
    const MeasuredWorld measured = equalIslands(16);
    const double one = frameMs(measured, 1, "none", true), two = frameMs(measured, 2, "none", true);
    EXPECT_NEAR(one, 5 + 1 + 16 * 9, 3);
    EXPECT_NEAR(two, 5 + 1 + 8 * 9, 3);
}

TEST(Scale, HomeWorksAsWell) { EXPECT_NEAR(frameMs(equalIslands(16), 1, "none"), 5 + 16 * 10 / 2.0, 12); }

TEST(Scale, ManyWorkersLeaveHomesPart) {
    const double frame = frameMs(equalIslands(32), 64, "infiniband");
    EXPECT_GT(frame, 5 + 9);
    EXPECT_LT(frame, 5 + 32 + 9 + 5);
}

TEST(Scale, WhatDoesNotPayStaysHome) {
    EXPECT_DOUBLE_EQ(frameMs(equalIslands(1), 16, "infiniband"), 15);
    EXPECT_DOUBLE_EQ(frameMs(equalIslands(16), 16, "0/1e4"), 165);
    EXPECT_DOUBLE_EQ(frameMs(equalIslands(16), 16, "1e9/0"), 165);
    EXPECT_EQ(predictScaling(equalIslands(1), readNetwork("infiniband"), {1, 2}).enough, 0u);
}

TEST(Scale, NoNetworkMakesAFrameLongerThanAtHome) {
    for (const Network &network : knownNetworks())
        for (const unsigned workers : {1u, 3u, 16u, 64u})
            for (const std::size_t islands : {2u, 7u, 40u}) {
                const MeasuredWorld measured = equalIslands(islands);
                const double frame = predictFrame(measured, {workers, network, false, true, 0});
                EXPECT_LE(frame, measured.homeFrameNs * 1.0001) << network.name << ", " << workers << " workers, " << islands << " islands";
                EXPECT_DOUBLE_EQ(frame, predictFrame(measured, {workers, network, false, true, 0})) << "predictions are the same twice";
            }
}

TEST(Scale, EnoughWorkersAreThoseBeyondWhichLittleIsGained) {
    const NetworkScaling scaling = predictScaling(equalIslands(16), readNetwork("infiniband"), {1, 2, 4, 8, 16, 32, 64});
    EXPECT_EQ(scaling.enough, 16u);
    for (std::size_t i = 1; i < scaling.frameNs.size(); ++i) EXPECT_LE(scaling.frameNs[i], scaling.frameNs[i - 1] * 1.05) << i;
}

// Measured once, a worker behind a simulated network: the model is held to what it said then. Each line of the file: world, network,
// workers, a frame at home in turns with those that were measured, which took the last number. Milliseconds.
TEST(Scale, PredictsRecordedScenarios) {
    std::istringstream lines(read(ODEMT_SCALE_DATA "/recorded.txt"));
    std::string world, network;
    unsigned workers = 0, count = 0;
    double homeMs = 0, measuredMs = 0;
    for (; lines >> world >> network >> workers >> homeMs >> measuredMs; ++count) {
        const MeasuredWorld measured = readMeasuredWorld(read(ODEMT_SCALE_DATA "/" + world + ".json"));
        const MeasuredWorld now = slowedDown(measured, homeMs * kMs / measured.homeFrameNs);
        const double frame = predictFrame(now, {workers, readNetwork(network), true, false, 2}) / kMs;
        std::printf("%s %s %u %g %g %g\n", world.c_str(), network.c_str(), workers, homeMs, frame, measuredMs);
        EXPECT_NEAR(frame / measuredMs, 1, 0.2) << world << " behind " << network << ", " << workers << " workers: " << frame << " ms";
    }
    EXPECT_GE(count, 10u);
}

TEST(Scale, AMeasuredWorldIsReadAsItWasWritten) {
    const MeasuredWorld measured = equalIslands(3);
    EXPECT_EQ(writeMeasuredWorld(readMeasuredWorld(writeMeasuredWorld(measured))), writeMeasuredWorld(measured));
    EXPECT_THROW(readMeasuredWorld("{}"), std::runtime_error);
    EXPECT_THROW(readMeasuredWorld("nonsense"), std::runtime_error);
}

TEST(Scale, ARecordIsReadByStepsWhateverTheOrder) {
    const std::vector<Step> steps = readWorkRecord("8 0 17 30 90 1000 5000 700\n7 1 1 2 6 300 400 60\n8 1 1 2 6 301 400 60\n");
    ASSERT_EQ(steps.size(), 2u);
    ASSERT_EQ(steps[1].size(), 2u);
    EXPECT_EQ(steps[0][0].bytes, 300);
    EXPECT_EQ(steps[1][0].joints, 30);
    EXPECT_EQ(steps[1][0].solveNs, 5000);
    EXPECT_EQ(steps[1][0].resultBytes, 700);
    EXPECT_THROW(readWorkRecord("1 2 3\n"), std::runtime_error);
}

TEST(Scale, NetworksAreNamedOrGiven) {
    EXPECT_EQ(readNetwork("1GbE").delayNs, 50e3);
    EXPECT_EQ(readNetwork("1e6/117e6").nsPerByte(), 1e9 / 117e6);
    EXPECT_EQ(readNetwork("1e6/117e6").workerArguments(), "--delay 1000000ns --bandwidth 117000000B/s");
    EXPECT_EQ(readNetwork("none").workerArguments(), "");
    for (const char *const wrong : {"", "2GbE", "1", "1/", "-1/0", "0/-1", "1/1x", "2e9/0", "nan/0"})
        EXPECT_THROW(readNetwork(wrong), std::invalid_argument) << wrong;
}

TEST(Scale, TheToolMeasuresAndPredicts) {
    const std::filesystem::path folder = testing::TempDir() + "scale_" + std::to_string(getpid());  // made by the tool
    const Outcome outcome =
        runShell(ODEMT_SCALE " --worlds humanoids:3 --transport loopback --seconds 0.2 --networks none,1GbE --workers 1,2 --save " + folder.string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "humanoids_3.json"));
    std::filesystem::remove_all(folder);
    for (const char *const word : {"humanoids:3: a frame takes", "3 islands of", "1GbE", "enough"})
        EXPECT_NE(outcome.output.find(word), std::string::npos) << word << ": " << outcome.output;
}

TEST(Scale, AKillWhileItLoadsEndsTheChild) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("scale_kill_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const Outcome outcome = runShell(
        ODEMT_SCALE " --worlds " + slowWorld(folder) +
        " --transport loopback --seconds 0.2 & P=$!; for i in $(seq 100); do "
        "C=$(cat /proc/$P/task/$P/children); C=${C%% *}; [ -n \"$C\" ] && break; sleep 0.1; done; sleep 1; [ -e /proc/$C/exe ] && echo loading; "
        "kill -TERM $P; sleep 1.5; [ -e /proc/$C/exe ] && echo goes on; echo done");
    EXPECT_NE(outcome.output.find("loading\n"), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find("goes on"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("done"), std::string::npos) << outcome.output;
    std::filesystem::remove_all(folder);
}

// The program's own log is not there then.
TEST(Scale, AJobThatDoesNotBeginIsNamed) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("scale_job_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "mpirun") << "#!/bin/sh\nexit 3\n";
    std::filesystem::permissions(folder / "mpirun", std::filesystem::perms::owner_all);
    const Outcome outcome = runShell("PATH=" + folder.string() + ":$PATH " ODEMT_SCALE " --worlds humanoids:3 --seconds 0.2");
    std::filesystem::remove_all(folder);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output;
    EXPECT_EQ(outcome.output.find("No such file"), std::string::npos) << outcome.output;
}

TEST(Scale, TheToolNamesWhatIsWrong) {
    for (const char *const arguments : {"--workers 0", "--workers x", "--networks 2GbE", "--worlds moon", "--our-library /tmp"}) {
        const Outcome outcome = runShell(std::string(ODEMT_SCALE " ") + arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments << ": " << outcome.output;
        EXPECT_NE(outcome.output.find("Run with --help"), std::string::npos) << outcome.output;
    }
    EXPECT_EQ(runShell(ODEMT_SCALE " --measured /no/such/file").exitCode, 1);
    // Before anything is measured.
    EXPECT_NE(runShell(ODEMT_SCALE " --worlds humanoids:3 --seconds 600 --save /proc/none").output.find("/proc/none"), std::string::npos);
}
