// A worker that was descheduled inside one run and continues during a later one.
//
// Covers dxJobBoard.cpp.
#include <mutex>
#include <set>

#include "ManagerKinds.h"
#include "Runs.h"
#include "threading/dxSchedulePoints.h"

namespace {

pthread_t caller;
std::atomic<int> held{0};
std::atomic<bool> released{false};

void holdWorkers() {
    if (pthread_equal(pthread_self(), caller)) return;
    ++held;
    waitUntil([] { return released.load(); }, 10);
}

// Two workers take seats of a run for three, and stop. The next run, on the same slot, is for two:
// no more than one of them may join it, and under a number of that run.
TEST_P(ThreadManagerTest, StaleWorkerTakesNothingFromALaterRun) {
    if (GetParam().waitsForIdleWorkers) GTEST_SKIP() << "a run ends only when all its threads have gone on";
    const auto manager = GetParam().make(3);
    ASSERT_TRUE(allWorkersMeet(*manager, 3));
    for (int i = 0; i < 10; ++i) {
        caller = pthread_self();
        held = 0;
        released = false;
        dxSetPerturbation(holdWorkers);
        runBlocks(*manager, 3, 3, [](unsigned, unsigned) { waitUntil([] { return held == 2; }, 0.05); });
        ASSERT_GT(held, 0);
        dxSetPerturbation(nullptr);

        std::mutex lock;
        std::set<pthread_t> threads;
        std::set<unsigned> numbers;
        runBlocks(*manager, 20, 2, [&](unsigned, unsigned worker) {
            released = true;
            {
                const std::lock_guard<std::mutex> hold(lock);
                threads.insert(pthread_self());
                numbers.insert(worker);
            }
            const timespec pause{0, 500000};
            nanosleep(&pause, nullptr);
        });
        EXPECT_LE(threads.size(), 2u);
        EXPECT_EQ(threads.size(), numbers.size());
    }
}

}  // namespace
