// Forward progress within a wall-clock budget, and quiet when there is nothing to do. Budgets are wide:
// what they catch (spin-only waits, waiting for a thread that does not run) takes many times longer.
//
// Covers dxFutex.cpp, dxParking.cpp.
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

#include "ManagerKinds.h"
#include "Runs.h"
#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxFutex.h"
#include "threading/pool/dxSpin.h"

namespace {

// The program's errno is its own: a caller may wait here, too.
TEST(Futex, SaysWhetherTheTimeHasPassedAndLeavesErrno) {
    dxFutexWord word{1};
    errno = EPERM;
    dxFutexWait(word, 0);
    EXPECT_EQ(errno, EPERM);
    EXPECT_TRUE(dxFutexWaitFor(word, 0, std::chrono::seconds(20)));
    EXPECT_EQ(errno, EPERM);
    const Stopwatch watch;
    EXPECT_FALSE(dxFutexWaitFor(word, 1, std::chrono::milliseconds(10)));
    EXPECT_EQ(errno, EPERM);
    EXPECT_GE(watch.seconds(), 0.009);
    EXPECT_LT(watch.seconds(), 10);
}

TEST_P(ThreadManagerTest, ProgressWithMoreWorkersThanCores) {
    const unsigned workers = std::min(16 * dxProcessorCount(), GetParam().maxWorkers);
    const auto manager = GetParam().make(workers);
    const Stopwatch watch;
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(everyBlockOnce(*manager, 2 * workers, workers));
    EXPECT_LT(watch.seconds(), 20);
}

std::atomic<pthread_t> heldCaller;
std::atomic<int> held{0};

// Every thread but the caller stops before it takes a block.
void holdWorkers() {
    if (pthread_equal(pthread_self(), heldCaller)) return;
    ++held;
    const timespec pause{2, 0};
    nanosleep(&pause, nullptr);
}

TEST_P(ThreadManagerTest, DescheduledWorkerDelaysNoOther) {
    const auto manager = GetParam().make(4);
    ASSERT_TRUE(allWorkersMeet(*manager, 4));
    heldCaller = pthread_self();
    held = 0;
    dxSetPerturbation(holdWorkers);
    const Stopwatch watch;
    runBlocks(*manager, 4, 4, [&](unsigned, unsigned worker) {
        // Gives the workers time to arrive and stop.
        if (worker == 0) waitUntil([] { return held > 0; }, 1);
    });
    const double seconds = watch.seconds();
    dxSetPerturbation(nullptr);
    EXPECT_GT(held, 0);
    // A run that waits for idle workers still ends once they continue.
    EXPECT_LT(seconds, GetParam().waitsForIdleWorkers ? 20 : 1.5);
}

double processorSeconds() {
    timespec used;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return used.tv_sec + used.tv_nsec * 1e-9;
}

TEST_P(ThreadManagerTest, IdleWorkersSleep) {
    for (const unsigned workers : {2u, 8u}) {
        const auto manager = GetParam().make(workers);
        ASSERT_TRUE(allWorkersMeet(*manager, workers));
        // libgomp spins for about 7 ms a thread where processors are left; this cannot be configured.
        const timespec runtimeSpins{0, 20000000}, second{1, 0};
        if (GetParam().waitsForIdleWorkers) nanosleep(&runtimeSpins, nullptr);
        const double before = processorSeconds();
        nanosleep(&second, nullptr);
        EXPECT_LT(processorSeconds() - before, 0.010) << workers << " workers";
    }
}

}  // namespace
