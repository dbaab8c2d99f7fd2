// Many runs on one manager: reuse, resize, stop and restart.
#include "ManagerKinds.h"
#include "processThreads.h"
#include "Runs.h"

namespace {

TEST_P(ThreadManagerTest, CanBeUsedThousandsOfTimes) {
    const auto manager = GetParam().make(3);
    for (int i = 0; i < 5000; ++i) ASSERT_TRUE(everyBlockOnce(*manager, 1 + i % 7, 3)) << "run " << i;
}

// Finds lost wake-ups: runs begin while workers are about to fall asleep, or have just done so.
TEST_P(ThreadManagerTest, WorkersComeToEveryRun) {
    const auto manager = GetParam().make(2);
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(allWorkersMeet(*manager, 2)) << "run " << i;
        const timespec pause{0, (i % 30) * 5000};
        nanosleep(&pause, nullptr);
    }
}

TEST_P(ThreadManagerTest, ResizesWhileIdle) {
    const auto manager = GetParam().make(8);
    for (const unsigned workers : {2u, 8u, 1u, 5u, 3u, 8u}) {
        manager->resize(workers);
        EXPECT_EQ(manager->workers(), workers);
        EXPECT_TRUE(everyBlockOnce(*manager, 100, 8));
        EXPECT_TRUE(allWorkersMeet(*manager, workers));
    }
}

TEST_P(ThreadManagerTest, BringsAbsurdSizesIntoRange) {
    const auto manager = GetParam().make(2);
    manager->resize(0);
    EXPECT_EQ(manager->workers(), 1u);
    manager->resize(~0u);
    EXPECT_LE(manager->workers(), 1024u);
    EXPECT_TRUE(everyBlockOnce(*manager, 10, 2));
}

TEST_P(ThreadManagerTest, StopsAndRestarts) {
    const auto manager = GetParam().make(3);
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(allWorkersMeet(*manager, 3));
        manager->stop();
        manager->stop();
    }
}

TEST_P(ThreadManagerTest, HasNoThreadsAfterStop) {
    if (!GetParam().endsThreads) GTEST_SKIP() << "the threads are the user's or the runtime's";
    const unsigned before = processThreads();
    const auto manager = GetParam().make(5);
    EXPECT_EQ(processThreads(), before) << "threads are started by the first run";
    EXPECT_TRUE(allWorkersMeet(*manager, 5));
    EXPECT_EQ(processThreads(), before + 4);
    manager->stop();
    EXPECT_TRUE(threadsFallTo(before));
}

}  // namespace
