// odemt_record as a user runs it.
#include "record/recording.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

#include "shell_run.h"
#include "support/text_file.h"

namespace {

class OdemtRecord : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    Outcome record(const std::string &arguments) const {
        return runShell(std::string(ODEMT_RECORD) + " " + arguments + " --output " + file);
    }

    record::Recording read() const {
        std::ifstream stream(file);
        return record::readRecording(stream);
    }

    const std::string folder = testing::TempDir() + "/odemt_record_" + std::to_string(getpid());
    const std::string file = folder + "/r.jsonl";
};

}  // namespace

TEST_F(OdemtRecord, KeepsOneFrameOfSoManyAndTheLast) {
    const Outcome outcome = record("soccer --frames 25 --every 10 --cells 8 --algorithm decluster");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.output;
    const record::Recording recording = read();
    EXPECT_EQ(recording.header.world, "soccer");
    EXPECT_EQ(recording.header.algorithm, "decluster");
    ASSERT_EQ(recording.frames.size(), 3u);
    EXPECT_EQ(recording.frames[0].number, 10);
    EXPECT_EQ(recording.frames[2].number, 25);
    EXPECT_NEAR(recording.frames[2].time, 25 * recording.header.stepSize, 1e-9);
    EXPECT_EQ(recording.frames[2].grid.cells, 8);
}

TEST_F(OdemtRecord, TellsTheClustersOfEverything) {
    ASSERT_EQ(record("soccer --frames 10 --cells 12 --algorithm static").exitCode, 0);
    const record::Recording recording = read();
    const record::Frame &frame = recording.frames.back();
    std::set<unsigned> names;
    std::size_t staticClusters = 0;
    for (std::size_t geom = 0; geom < recording.header.geoms.size(); ++geom) {
        const record::Membership &membership = frame.memberships[geom];
        const int body = recording.header.geoms[geom].body;
        if (body == record::Geom::kStatic) {
            EXPECT_EQ(membership.cluster, 0u);
            staticClusters += membership.staticCluster != 0;
            continue;
        }
        EXPECT_NE(membership.cluster, 0u);
        EXPECT_EQ(membership.cluster, frame.bodyClusters[static_cast<std::size_t>(body)]);
        EXPECT_EQ(membership.testedWith, (std::vector<unsigned>{membership.cluster}));
        names.insert(membership.cluster);
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(frame.clusters));
    EXPECT_GT(names.size(), 1u);
    EXPECT_GT(staticClusters, 0u);
    for (const record::Cell &cell : frame.cells) EXPECT_EQ(names.count(cell.cluster), 1u);
}

TEST_F(OdemtRecord, TellsMergesAndSplitsBetweenTheFramesItKeeps) {
    ASSERT_EQ(record("soccer --frames 400 --every 400 --cells 12 --algorithm decluster").exitCode, 0);
    int merges = 0, splits = 0;
    const record::Recording recording = read();
    for (const record::Event &event : recording.frames.back().events) ++(event.isSplit ? splits : merges);
    EXPECT_GT(merges, 0);
    EXPECT_GT(splits, 0);
}

TEST_F(OdemtRecord, TellsIslandsAndWhoIsAwake) {
    ASSERT_EQ(record("stacks:3 --frames 60 --every 60").exitCode, 0);
    const record::Frame frame = read().frames.back();
    ASSERT_EQ(frame.islands.size(), frame.bodies.size());
    std::set<int> islands(frame.islands.begin(), frame.islands.end());
    EXPECT_EQ(islands, (std::set<int>{0, 1, 2}));  // the boxes of a stack lie on each other
    EXPECT_EQ(frame.awake, std::vector<bool>(frame.bodies.size(), true));
    EXPECT_EQ(frame.velocities.size(), frame.bodies.size());
    EXPECT_FALSE(frame.contacts);
}

// What rests is held by the ground: forces of the contacts with it are the weight.
TEST_F(OdemtRecord, TellsContactsAndTheirForces) {
    ASSERT_EQ(record("stacks:1 --frames 200 --every 200 --contacts").exitCode, 0);
    const record::Recording recording = read();
    const record::Frame &frame = recording.frames.back();
    ASSERT_TRUE(frame.contacts);
    double onGround = 0, onBoxes = 0;
    for (const record::Contact &contact : *frame.contacts) {
        const auto isStatic = [&](int geom) { return recording.header.geoms[static_cast<std::size_t>(geom)].body == record::Geom::kStatic; };
        if (isStatic(contact.geom1)) onGround += contact.force[2];
        if (isStatic(contact.geom2)) onBoxes += contact.force[2];
    }
    EXPECT_GT(onBoxes - onGround, 0);
    EXPECT_LE(onGround, 0);
    EXPECT_GE(onBoxes, 0);
}

// Which thread takes an island is up to the moment, but steps are long enough for a worker to come.
TEST_F(OdemtRecord, TellsWhichThreadHasSteppedEachBody) {
    ASSERT_EQ(record("humanoids:22 --frames 60 --every 2 --threads 2").exitCode, 0);
    std::set<int> seen;
    for (const record::Frame &frame : read().frames) {
        ASSERT_EQ(frame.workers.size(), frame.bodies.size());
        for (std::size_t body = 0; body < frame.workers.size(); ++body) {
            EXPECT_EQ(frame.workers[body], frame.workers[static_cast<std::size_t>(
                                               std::find(frame.islands.begin(), frame.islands.end(), frame.islands[body]) -
                                               frame.islands.begin())]);
            seen.insert(frame.workers[body]);
        }
    }
    EXPECT_EQ(seen, (std::set<int>{0, 1}));
    ASSERT_EQ(record("stacks:6 --frames 1").exitCode, 0);
    EXPECT_TRUE(read().frames.back().workers.empty());
}

TEST_F(OdemtRecord, TellsTheNamesOfAnSdfWorldsBodies) {
    ASSERT_EQ(record("create --frames 1").exitCode, 0);
    const record::Recording create = read();
    ASSERT_EQ(create.header.bodyNames.size(), create.frames.back().bodies.size());
    EXPECT_NE(create.header.bodyNames[0].find("::"), std::string::npos) << create.header.bodyNames[0];
    ASSERT_EQ(record("stacks:1 --frames 1").exitCode, 0);
    EXPECT_TRUE(read().header.bodyNames.empty());
}

TEST_F(OdemtRecord, StockAndOursMoveEverythingAlike) {
    ASSERT_EQ(record("pile:20 --frames 60 --stock --contacts").exitCode, 0);
    const record::Recording stock = read();
    ASSERT_EQ(record("pile:20 --frames 60").exitCode, 0);
    const record::Recording ours = read();
    EXPECT_EQ(stock.header.library.find(ODEMT_OUR_FOLDER), std::string::npos);
    EXPECT_EQ(stock.frames.back().grid.cells, 0);
    ASSERT_EQ(stock.frames.size(), ours.frames.size());
    for (std::size_t i = 0; i < ours.frames.size(); ++i) {
        for (std::size_t body = 0; body < ours.frames[i].bodies.size(); ++body) {
            EXPECT_EQ(stock.frames[i].bodies[body].position, ours.frames[i].bodies[body].position);
            EXPECT_EQ(stock.frames[i].bodies[body].quaternion, ours.frames[i].bodies[body].quaternion);
            EXPECT_EQ(stock.frames[i].velocities[body].angular, ours.frames[i].velocities[body].angular);
        }
        EXPECT_EQ(stock.frames[i].islands, ours.frames[i].islands);
    }
}

TEST_F(OdemtRecord, IsTheSameEveryTime) {
    ASSERT_EQ(record("bioloid --frames 20 --cells 10").exitCode, 0);
    const std::string first = support::readTextFile(file);
    ASSERT_EQ(record("bioloid --frames 20 --cells 10").exitCode, 0);
    EXPECT_TRUE(support::readTextFile(file) == first);
}

TEST_F(OdemtRecord, WrongOptionsAreAnsweredByName) {
    for (const auto &[arguments, word] :
         std::vector<std::pair<std::string, std::string>>{{"moon", "'moon'"},
                                                          {"soccer --algorithm lcp", "--algorithm"},
                                                          {"soccer --cells 4", "--cells: 4"},
                                                          {"soccer --every 0", "--every"},
                                                          {"soccer --threads 2 --stock", "--threads"},
                                                          {"soccer --threads 1025", "--threads"},
                                                          {"soccer --wurld", "--wurld"}}) {
        const Outcome outcome = record(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments;
        EXPECT_NE(outcome.output.find(word), std::string::npos) << outcome.output;
    }
}

TEST_F(OdemtRecord, TheWrongLibraryIsNamed) {
    const Outcome outcome =
        runShell("LD_LIBRARY_PATH=" + std::string(ODEMT_STOCK_FOLDER) + " " + ODEMT_RECORD + " soccer");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.output.find("it is not ODE_MT"), std::string::npos) << outcome.output;
}

TEST_F(OdemtRecord, AFileThatCannotBeWrittenIsNamed) {
    const Outcome outcome = runShell(std::string(ODEMT_RECORD) + " soccer --frames 1 --output /proc/r.jsonl");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.output.find("/proc/r.jsonl"), std::string::npos) << outcome.output;
}
