// The program as a user runs it.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "platform.h"
#include "shell_run.h"
#include "slow_world.h"

namespace {

// Stock is the library that ours has the bits of, which need not be this system's own.
Outcome run(const std::string &arguments) {
    return runShell(std::string(ODEMT_BENCH) + " --stock-library " ODEMT_STOCK_FOLDER " " + arguments);
}

class OdemtBench : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::string files() const { return " --json " + folder + "/b.json --csv " + folder + "/b.csv"; }

    const std::string folder = testing::TempDir() + "/odemt_bench_" + std::to_string(getpid());
};

}  // namespace

TEST_F(OdemtBench, ComparesEnginesAndSavesTheFigures) {
    const Outcome outcome =
        run("--worlds rover:3,stacks:2 --engines stock,ours:0,ours:2 --frames 200" + files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("== rover:3 =="), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find("WRONG"), std::string::npos);
    EXPECT_EQ(outcome.output.find("2 worlds (rover:3, stacks:2) on 3 engines (stock, ours:0, ours:2): at most "), 0u) << outcome.output;
    EXPECT_NE(outcome.output.find("times the speed of libode8 on rover:3"), std::string::npos) << outcome.output;

    std::ifstream file(folder + "/b.json");
    const auto json = nlohmann::json::parse(file);
    ASSERT_EQ(json["worlds"].size(), 2u);
    for (const auto &world : json["worlds"]) {
        EXPECT_EQ(world["frames"], 200);
        ASSERT_EQ(world["engines"].size(), 3u);
        for (const auto &engine : world["engines"]) EXPECT_EQ(engine["hash"], world["engines"][0]["hash"]);
    }
    EXPECT_TRUE(std::filesystem::exists(folder + "/b.csv"));
}

// A copy under the name of another release stands in for that release.
TEST_F(OdemtBench, ReleasesThatDifferAreToldBesideTheFigures) {
    const std::string release = bench::releaseOfLibrary(ODEMT_ORACLE), number = release == "0.16.2" ? "8.2.0" : "8.0.2";
    const std::string other = folder + "/libode.so." + number;
    std::filesystem::copy_file(ODEMT_ORACLE, other);
    const Outcome outcome = run("--worlds rover:3 --engines stock,stock:" + other + ",ours:2 --frames 100" + files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("\nODE " + release + ": stock, ours:2\nODE " + bench::releaseOfLibrary(other) + ": stock:" + other + "\n"),
              std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("note: the releases of ODE differ"), std::string::npos) << outcome.output;
    std::ifstream file(folder + "/b.json");
    const auto engines = nlohmann::json::parse(file)["worlds"][0]["engines"];
    EXPECT_EQ(engines[1]["engine"], "stock:" + other);
    EXPECT_EQ(engines[1]["library"], std::filesystem::canonical(other).string());
    EXPECT_EQ(engines[1]["release"], bench::releaseOfLibrary(other));
    EXPECT_EQ(engines[1]["state"], "other release");
    EXPECT_EQ(engines[2]["release"], ODEMT_UPSTREAM);
}

// What is printed fits into the terminal's buffer, so that it can be read in the end.
TEST_F(OdemtBench, ABarGrowsOnATerminal) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    ASSERT_TRUE(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
    const int other = open(ptsname(terminal), O_RDWR | O_NOCTTY);  // until it is read, or the text would be gone
    const Outcome outcome = run("--worlds pile:100 --engines ours:0 --seconds 1.5" + files() + " 2>" + ptsname(terminal));
    std::string shown(1 << 16, '\0');
    shown.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(terminal, shown.data(), shown.size()))));
    close(other);
    close(terminal);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    const std::size_t first = shown.find("\r\033[K["), last = shown.rfind("\r\033[K[");
    ASSERT_LT(first, last) << shown;
    EXPECT_LT(shown.find('-', first), shown.find('-', last) - (last - first)) << shown;
    EXPECT_NE(shown.find(" s left; world 1 of 1: pile:100: "), std::string::npos) << shown;
}

TEST_F(OdemtBench, TimesCallbacksApart) {
    const Outcome outcome =
        run("--worlds stacks:20 --engines stock,ours:0,ours:2/concurrent --frames 200 --time-callbacks" +
            files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    std::ifstream file(folder + "/b.json");
    const auto json = nlohmann::json::parse(file);
    for (const auto &engine : json["worlds"][0]["engines"]) {
        const auto seconds = [&](const char *part) {
            return engine["parts"][part]["meanSeconds"].get<double>();
        };
        EXPECT_GT(seconds("callbacks"), 1e-6);  // there are more than a hundred pairs in each frame
        EXPECT_NEAR(seconds("outside_callbacks"), seconds("frame") - seconds("callbacks"), 1e-9);
        if (engine["callbacks"] != "concurrent") {
            EXPECT_LT(seconds("callbacks"), seconds("collision"));
        }
    }
}

// Islands of the stacks are shared, the search for them is not.
TEST_F(OdemtBench, TellsTheSerialShare) {
    const Outcome outcome = run("--worlds stacks:20 --engines stock,ours:2/lcp --frames 100 --serial-share" + files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("\nours:2/lcp: "), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find(" % of the work is one thread's: with 4, 8, 16 cores at most "), std::string::npos) << outcome.output;
    std::ifstream file(folder + "/b.json");
    const auto json = nlohmann::json::parse(file);
    EXPECT_TRUE(json["worlds"][0]["engines"][0]["serialShare"].is_null());
    const double share = json["worlds"][0]["engines"][1]["serialShare"].get<double>();
    EXPECT_GT(share, 0.01);
    EXPECT_LT(share, 0.9);
}

TEST_F(OdemtBench, PrintsTimeOverSizeWithoutStock) {
    const Outcome outcome = run("--worlds stacks:2..8,sap --engines ours:0,ours:2 --frames 20" + files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("== stacks:N,sap: time over size =="), std::string::npos) << outcome.output;
    std::ifstream file(folder + "/b.json");
    const auto json = nlohmann::json::parse(file);
    EXPECT_EQ(json["curves"][0]["sizes"], nlohmann::json({2, 4, 8}));
}

TEST_F(OdemtBench, SavesSamplesOfTheRealTimeFactor) {
    const Outcome outcome =
        run("--worlds rover:3 --engines stock --seconds 1.5 --samples " + folder + "/s.csv" + files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    std::ifstream file(folder + "/s.csv");
    std::string header, line;
    std::getline(file, header);
    EXPECT_EQ(header, "world,engine,second,real_time_factor");
    std::getline(file, line);
    EXPECT_EQ(line.compare(0, 16, "rover:3,stock,1,"), 0) << line;
    EXPECT_GT(std::stod(line.substr(16)), 0);
}

TEST_F(OdemtBench, ThePageIsWrittenWithTheResults) {
    const Outcome outcome = run("--worlds rover:3 --engines stock,ours:2 --frames 100 --html " + folder + "/b.html" + files());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    std::ifstream file(folder + "/b.html");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(page.compare(0, 15, "<!DOCTYPE html>"), 0);
    EXPECT_NE(page.find("\"world\": \"rover:3\""), std::string::npos);
}

TEST_F(OdemtBench, AFailingEngineMakesTheExitCodeOneAndIsNamed) {
    // Debian's library in place of ours.
    const Outcome outcome = run("--worlds rover:3 --engines stock,ours:1 --frames 20 --our-library " +
                                std::string(ODEMT_STOCK_FOLDER) + files());
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.output.find("FAILED: ours:1"), std::string::npos) << outcome.output;
}

TEST_F(OdemtBench, AWrongOptionMakesTheExitCodeTwo) {
    const Outcome outcome = run("--worlds moon");
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.output.find("'moon'"), std::string::npos);
}

TEST_F(OdemtBench, ListsWorlds) {
    const Outcome outcome = run("--list");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.output.find("ragdolls"), std::string::npos);
}

TEST_F(OdemtBench, AFileThatCannotBeWrittenIsNamed) {
    const Outcome outcome =
        run("--worlds rover:3 --engines stock --frames 20 --json /proc/b.json --csv " + folder + "/b.csv");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.output.find("/proc/b.json"), std::string::npos);
}

// The old file stays where the new one does not fit, and no temporary file is left.
TEST_F(OdemtBench, AFullDiskLeavesTheOldFile) {
    std::ofstream(folder + "/b.json") << "old";
    const auto [exitCode, output] = runShell("bash -c 'ulimit -f 1; " + std::string(ODEMT_BENCH) +
                                             " --worlds rover:3 --engines ours:0 --frames 2000" + files() + "'");
    EXPECT_NE(exitCode, 0);
    EXPECT_NE(output.find("cannot write '" + folder + "/b.json': File too large"), std::string::npos)
        << output;
    std::string text;
    std::ifstream(folder + "/b.json") >> text;
    EXPECT_EQ(text, "old");
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        EXPECT_EQ(entry.path().filename().string().find("b.json."), std::string::npos);
}

TEST_F(OdemtBench, AKillLeavesTheWorldsThatWereMeasured) {
    const Outcome outcome =
        run("--worlds rover:3,pile:4000 --engines ours:0 --seconds 100 --frames 3000" +
            files() + " & P=$!; for i in $(seq 300); do [ -e " + folder +
            "/b.json ] && break; sleep 0.1; done; kill -9 $P; wait");
    std::ifstream file(folder + "/b.json");
    ASSERT_TRUE(file) << outcome.output;
    EXPECT_EQ(nlohmann::json::parse(file)["worlds"].size(), 1u);
}

TEST_F(OdemtBench, AKillWhileItLoadsEndsTheChild) {
    const std::string world = slowWorld(folder);
    const std::string child = "$(cat /proc/$P/task/$P/children)";
    const Outcome outcome = run("--worlds " + world + " --engines ours:0" + files() +
                                " & P=$!; for i in $(seq 100); do C=" + child +
                                "; C=${C% }; [ -n \"$C\" ] && break; sleep 0.1; done; sleep 1; [ -e /proc/$C/exe ] && echo loading; kill -TERM $P; "
                                "sleep 1.5; [ -e /proc/$C/exe ] && echo goes on; echo done");
    EXPECT_NE(outcome.output.find("loading\n"), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find("goes on"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("done"), std::string::npos) << outcome.output;
}

// `script` draws its input on a terminal.
TEST_F(OdemtBench, SaysOnATerminalWhatItLoads) {
    const std::string world = slowWorld(folder);
    const Outcome outcome = runShell("timeout -s KILL 4 script -qec '" + std::string(ODEMT_BENCH) + " --worlds " + world +
                                     " --engines ours:0 --frames 1" + files() + "' /dev/null");
    EXPECT_NE(outcome.output.find("loading " + world + " for ours:0"), std::string::npos) << outcome.output;
}

TEST_F(OdemtBench, StartsOnOurLibraryWhereDebiansIsMissing) {
    const std::string command = "LD_TRACE_LOADED_OBJECTS=1 " + std::string(ODEMT_BENCH);
    const std::string output = runShell(command).output;
    EXPECT_NE(output.find("libode.so.8 => " + std::string(ODEMT_OUR_FOLDER)), std::string::npos) << output;
}
