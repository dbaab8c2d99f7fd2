#include "competitor.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "complaint.h"

using namespace bench;

namespace {

ChildSettings settings() {
    ChildSettings settings;
    settings.program = ODEMT_BENCH_CHILD;
    settings.stockFolder = ODEMT_STOCK_FOLDER;
    settings.oursFolder = ODEMT_OUR_FOLDER;
    return settings;
}

// A program in place of the child, to misbehave as no real one does.
class Script {
public:
    explicit Script(const std::string &text) {
        std::ofstream(file) << "#!/bin/sh\n" << text;
        chmod(file.c_str(), 0700);
    }
    ~Script() { std::remove(file.c_str()); }

    const std::string file = testing::TempDir() + "/bench_child_" + std::to_string(getpid());
};

// The hash of the world's state after `frames` frames.
auto hashAfter(int frames, const std::string &world, const std::string &engine) {
    ChildCompetitor competitor(readEngine(engine), world, settings());
    competitor.start();
    return competitor.run(frames).hash;
}

}  // namespace

TEST(ChildCompetitor, StockRunsOnDebiansLibrary) {
    ChildCompetitor stock(readEngine("stock"), "stacks:2", settings());
    const Ready ready = stock.start();
    EXPECT_FALSE(ready.isOurs);
    EXPECT_EQ(ready.bodies, 20u);
    EXPECT_EQ(stock.run(10).frames, 10);
}

TEST(ChildCompetitor, OursRunsOnOurLibraryWithItsThreads) {
    ChildCompetitor ours(readEngine("ours:2/pthread/lcp"), "stacks:2", settings());
    const Ready ready = ours.start();
    EXPECT_TRUE(ready.isOurs);
    EXPECT_EQ(ready.threads, 2);
    EXPECT_EQ(ready.manager, "pthread");
    EXPECT_EQ(ready.algorithm, "lcp");
    EXPECT_EQ(ours.run(10).sharedSteps, 10u);
}

TEST(ChildCompetitor, OursRunsWithItsCallbacksAndGrid) {
    ChildCompetitor ours(readEngine("ours:2/decluster/concurrent/cells=8"), "stacks:2", settings());
    const Ready ready = ours.start();
    EXPECT_EQ(ready.algorithm, "decluster");
    EXPECT_EQ(ready.callbacks, "concurrent");
    EXPECT_EQ(ready.gridCells, 8);
}

TEST(ChildCompetitor, ConcurrentCallbacksOfAnSdfWorldGiveTheSameState) {
    EXPECT_EQ(hashAfter(100, "humanoids", "stock"), hashAfter(100, "humanoids", "ours:4/lcp/concurrent"));
}

TEST(ChildCompetitor, BothEnginesGiveTheSameState) {
    EXPECT_EQ(hashAfter(50, "humanoids:2", "stock"), hashAfter(50, "humanoids:2", "ours:2"));
}

TEST(ChildCompetitor, ThePoolRuns) {
    ChildCompetitor pool(readEngine("stock-pool:2"), "stacks:2", settings());
    pool.start();
    EXPECT_EQ(pool.run(5).frames, 5);
}

TEST(ChildCompetitor, TheUsersOwnSettingsDoNotReachTheEngines) {
    setenv("ODE_MT_ALGORITHM", "serial", 1);
    setenv("ODE_MT_CALLBACKS", "concurrent", 1);
    setenv("ODE_MT_GRID_CELLS", "8", 1);
    ChildCompetitor ours(readEngine("ours:2"), "stacks:2", settings());
    const Ready ready = ours.start();
    for (const char *variable : {"ODE_MT_ALGORITHM", "ODE_MT_CALLBACKS", "ODE_MT_GRID_CELLS"})
        unsetenv(variable);
    EXPECT_NE(ready.algorithm, "serial");
    EXPECT_NE(ready.callbacks, "concurrent");
    EXPECT_EQ(ready.gridCells, 0);
}

TEST(ChildCompetitor, TheWrongLibraryIsNoticed) {
    ChildSettings swapped = settings();
    std::swap(swapped.stockFolder, swapped.oursFolder);
    ChildCompetitor stock(readEngine("stock"), "stacks:2", swapped);
    EXPECT_NE(complaint([&] { stock.start(); }).find("which is ODE_MT"), std::string::npos);
    ChildCompetitor ours(readEngine("ours:1"), "stacks:2", swapped);
    EXPECT_NE(complaint([&] { ours.start(); }).find("which is not ODE_MT"), std::string::npos);
}

// Of any name, in any folder, also one that the loader would take for two.
TEST(ChildCompetitor, AnotherLibraryIsRunByItsPath) {
    const std::string folder = testing::TempDir() + "/bench other:" + std::to_string(getpid());
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(ODEMT_ORACLE, folder + "/mine.so");
    std::filesystem::create_symlink("mine.so", folder + "/libode.so.8");
    ChildCompetitor ours(readEngine("ours:0"), "stacks:2", settings());
    ours.start();
    const std::uint64_t hash = ours.run(20).hash;
    for (const std::string &path : {folder + "/mine.so", folder + "/libode.so.8", folder}) {
        ChildCompetitor other(readEngine("stock:" + path), "stacks:2", settings());
        const Ready ready = other.start();
        EXPECT_EQ(ready.library, std::filesystem::canonical(folder + "/mine.so"));
        EXPECT_FALSE(ready.isOurs);
        EXPECT_EQ(ready.release, kUnknownRelease);
        EXPECT_EQ(other.run(20).hash, hash);
    }
    std::filesystem::remove_all(folder);
}

TEST(ChildCompetitor, TheReleasesAreTold) {
    ChildCompetitor ours(readEngine("ours:0"), "stacks:2", settings()), oracle(readEngine("stock:" ODEMT_ORACLE), "stacks:2", settings());
    EXPECT_EQ(ours.start().release, ODEMT_UPSTREAM);
    EXPECT_EQ(oracle.start().release, releaseOfLibrary(ODEMT_ORACLE));
}

// The loader looks further without a word; the system's library would be measured in its place.
TEST(ChildCompetitor, ALibraryThatTheLoaderPassesOverIsNoticed) {
    const std::string file = testing::TempDir() + "/bench_32_bits_" + std::to_string(getpid());
    std::ofstream(file) << std::string("\x7f" "ELF\x01\x01\x01", 7) << std::string(500, '\0');
    ChildCompetitor other(readEngine("stock:" + file), "stacks:2", settings());
    EXPECT_NE(complaint([&] { other.start(); }).find(", not on " + file), std::string::npos);
    std::remove(file.c_str());
}

TEST(ChildCompetitor, AnUnknownWorldIsReportedInTheChildsWords) {
    ChildCompetitor stock(readEngine("stock"), "moon", settings());
    EXPECT_NE(complaint([&] { stock.start(); }).find("unknown world 'moon'"), std::string::npos);
}

TEST(ChildCompetitor, ACrashAtTheStartIsReported) {
    const Script script("echo out of memory >&2; exit 7\n");
    ChildSettings broken = settings();
    broken.program = script.file;
    ChildCompetitor stock(readEngine("stock"), "rover", broken);
    EXPECT_EQ(complaint([&] { stock.start(); }), "ended with exit code 7: out of memory");
}

TEST(ChildCompetitor, AHangInABatchIsReportedAndEnded) {
    const Script script(std::string("echo '") + writeReady({}) + "'\nread request\nsleep 60\n");
    ChildSettings hanging = settings();
    hanging.program = script.file;
    hanging.limit = std::chrono::seconds(1);
    ChildCompetitor stock(readEngine("stock"), "rover", hanging);
    stock.start();
    EXPECT_EQ(complaint([&] { stock.run(1); }), "no answer within 1 s");
}
