// Runs at the same time: from several user threads, and nested.
//
// Covers dxJobBoard.cpp, dxThreadManagerOpenMP.cpp, dxThreadManagerPthread.cpp.
#include <thread>

#include "ManagerKinds.h"
#include "Runs.h"
#include "threading/dxSchedulePoints.h"

namespace {

void hammer(dxThreadManager &manager, int runs, std::atomic<int> &faults) {
    for (int i = 0; i < runs; ++i) {
        if (!everyBlockOnce(manager, 20, 4)) ++faults;
    }
}

int hammerFromThreads(dxThreadManager &manager, unsigned threads, int runs) {
    std::atomic<int> faults{0};
    std::vector<std::thread> users;
    for (unsigned i = 0; i < threads; ++i) users.emplace_back([&] { hammer(manager, runs, faults); });
    for (std::thread &user : users) user.join();
    return faults;
}

TEST_P(ThreadManagerTest, EightUserThreadsAtOnce) {
    const auto manager = GetParam().make(4);
    EXPECT_EQ(hammerFromThreads(*manager, 8, 500), 0);
}

// More runs at one time than the job board holds.
TEST_P(ThreadManagerTest, HundredUserThreadsAtOnce) {
    const auto manager = GetParam().make(2);
    EXPECT_EQ(hammerFromThreads(*manager, 100, 20), 0);
}

TEST_P(ThreadManagerTest, NestedRuns) {
    const auto manager = GetParam().make(4);
    for (int i = 0; i < 200; ++i) {
        std::atomic<int> leaves{0};
        runBlocks(*manager, 6, 4, [&](unsigned, unsigned) {
            runBlocks(*manager, 5, 4, [&](unsigned, unsigned) {
                runBlocks(*manager, 3, 4, [&](unsigned, unsigned) { ++leaves; });
            });
        });
        ASSERT_EQ(leaves, 6 * 5 * 3);
    }
}

TEST_P(ThreadManagerTest, NestedRunGetsIdleWorkers) {
    if (!GetParam().sharesConcurrentRuns) GTEST_SKIP() << "a nested run is done by its caller alone";
    const auto manager = GetParam().make(3);
    bool met = false;
    runBlocks(*manager, 2, 2, [&](unsigned block, unsigned) {
        if (block == 0) met = allWorkersMeet(*manager, 2);
    });
    EXPECT_TRUE(met);
}

// Two runs that want one worker each, with two idle: both get one.
TEST_P(ThreadManagerTest, ConcurrentRunsShareTheWorkers) {
    if (!GetParam().sharesConcurrentRuns) GTEST_SKIP() << "one run at a time has workers";
    const auto manager = GetParam().make(3);
    for (int i = 0; i < 50; ++i) {
        Meeting meeting(4);
        const auto user = [&] { runBlocks(*manager, 2, 2, [&](unsigned, unsigned) { meeting.attend(); }); };
        std::thread other(user);
        user();
        other.join();
        ASSERT_TRUE(meeting.complete()) << "round " << i;
    }
}

TEST_P(ThreadManagerTest, PerturbedSchedule) {
    const auto manager = GetParam().make(5);
    dxSetRandomPerturbation(42);
    EXPECT_EQ(hammerFromThreads(*manager, 4, 30), 0);
    dxSetPerturbation(nullptr);
}

}  // namespace
