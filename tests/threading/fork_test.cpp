// fork in the host program: the child has workers again where the manager can give them, the parent
// notices nothing.
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "ManagerKinds.h"
#include "Runs.h"

namespace {

// Runs the function in a forked child, at most 30 s, and returns whether it returned true there.
template <typename Function>
bool trueInChild(Function function) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(30);
        _exit(function() ? 0 : 1);
    }
    int status = 0;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_P(ThreadManagerTest, WorksInAForkedChild) {
    const auto manager = GetParam().make(4);
    ASSERT_TRUE(allWorkersMeet(*manager, 4));
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(trueInChild([&] { return everyBlockOnce(*manager, 100, 4); }));
        EXPECT_TRUE(allWorkersMeet(*manager, 4)) << "the parent";
    }
}

TEST_P(ThreadManagerTest, ForkedChildGetsItsOwnWorkers) {
    if (!GetParam().workersInForkedChild) GTEST_SKIP() << "no threads in the child";
    const auto manager = GetParam().make(4);
    ASSERT_TRUE(allWorkersMeet(*manager, 4));
    EXPECT_TRUE(trueInChild([&] {
        const bool met = allWorkersMeet(*manager, 4, 10);
        manager->stop();
        return met && allWorkersMeet(*manager, 4, 10);
    }));
}

TEST_P(ThreadManagerTest, ForkWhileAnotherThreadRuns) {
    const auto manager = GetParam().make(3);
    std::atomic<bool> enough{false};
    std::thread other([&] {
        while (!enough) everyBlockOnce(*manager, 10, 3);
    });
    for (int i = 0; i < 20; ++i) {
        EXPECT_TRUE(trueInChild([&] { return everyBlockOnce(*manager, 100, 3); })) << "child " << i;
    }
    enough = true;
    other.join();
}

// The second generation: a child that forks.
TEST_P(ThreadManagerTest, ForkInAForkedChild) {
    const auto manager = GetParam().make(2);
    EXPECT_TRUE(trueInChild([&] {
        return everyBlockOnce(*manager, 50, 2) &&
               trueInChild([&] { return everyBlockOnce(*manager, 50, 2); });
    }));
}

}  // namespace
