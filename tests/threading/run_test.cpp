// What one run promises: every block once, in ascending order, worker numbers, visible writes.
//
// Covers dxJobBoard.cpp, dxOpenMPRuntime.cpp, dxThreadManagerOpenMP.cpp, dxThreadManagerPthread.cpp.
#include <algorithm>

#include "ManagerKinds.h"
#include "Runs.h"

namespace {

constexpr unsigned workerCounts[] = {1, 2, 3, 5, 8, 16, 64, 1024};

TEST_P(ThreadManagerTest, RunsEveryBlockOnce) {
    for (const unsigned workers : workerCounts) {
        if (workers > GetParam().maxWorkers) continue;
        const auto manager = GetParam().make(workers);
        for (const unsigned blocks : {0u, 1u, 2u, workers - 1, workers, workers + 1, 10 * workers}) {
            EXPECT_TRUE(everyBlockOnce(*manager, blocks, workers))
                << workers << " workers, " << blocks << " blocks";
        }
    }
}

TEST_P(ThreadManagerTest, AllWorkersTakePartUnderTheirOwnNumbers) {
    for (const unsigned workers : workerCounts) {
        if (workers > GetParam().maxWorkers) continue;
        const auto manager = GetParam().make(workers);
        Meeting meeting(workers);
        std::vector<std::atomic<unsigned>> uses(workers);
        runBlocks(*manager, workers, workers, [&](unsigned, unsigned worker) {
            ++uses.at(worker);
            meeting.attend();
        });
        EXPECT_TRUE(meeting.complete()) << workers << " workers";
        EXPECT_TRUE(std::all_of(uses.begin(), uses.end(), [](unsigned n) { return n == 1; }))
            << workers << " workers";
    }
}

TEST_P(ThreadManagerTest, GivesAWorkerNumberToOneThreadAtATime) {
    const auto manager = GetParam().make(8);
    for (const unsigned maxWorkers : {1u, 2u, 5u, 8u, 100u}) {
        std::vector<std::atomic<int>> inUse(std::min(maxWorkers, 8u));
        std::atomic<int> faults{0};
        runBlocks(*manager, 2000, maxWorkers, [&](unsigned, unsigned worker) {
            if (worker >= inUse.size() || ++inUse[worker] != 1) {
                ++faults;
            } else {
                --inUse[worker];
            }
        });
        EXPECT_EQ(faults, 0) << "at most " << maxWorkers << " workers";
    }
}

TEST_P(ThreadManagerTest, CallerIsWorkerZero) {
    const auto manager = GetParam().make(4);
    const pthread_t caller = pthread_self();
    std::atomic<int> faults{0};
    runBlocks(*manager, 1000, 4, [&](unsigned, unsigned worker) {
        if ((worker == 0) != (pthread_equal(pthread_self(), caller) != 0)) ++faults;
    });
    EXPECT_EQ(faults, 0);
}

TEST_P(ThreadManagerTest, HandsOutBlocksInAscendingOrder) {
    const auto manager = GetParam().make(4);
    std::vector<std::vector<unsigned>> taken(4);
    runBlocks(*manager, 1000, 4, [&](unsigned block, unsigned worker) { taken[worker].push_back(block); });
    for (const std::vector<unsigned> &blocks : taken)
        EXPECT_TRUE(std::is_sorted(blocks.begin(), blocks.end()));
}

// A block may start only when all lower ones have been assigned; they are then at most as many as there
// are other workers away from having started.
TEST_P(ThreadManagerTest, StartsNoBlockFarAheadOfALowerOne) {
    constexpr unsigned workers = 3, blocks = 3000;
    const auto manager = GetParam().make(workers);
    std::atomic<unsigned> startedBlocks{0};
    std::atomic<int> faults{0};
    runBlocks(*manager, blocks, workers, [&](unsigned block, unsigned) {
        if (++startedBlocks + workers - 1 < block + 1) ++faults;
    });
    EXPECT_EQ(faults, 0);
}

TEST_P(ThreadManagerTest, OneWorkerRunsOnTheCallerInOrder) {
    const auto manager = GetParam().make(4);
    std::vector<unsigned> order;
    runBlocks(*manager, 50, 1, [&](unsigned block, unsigned) { order.push_back(block); });
    ASSERT_EQ(order.size(), 50u);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

}  // namespace
