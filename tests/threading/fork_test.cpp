// fork in the host program: the child has workers again where the manager can give them, the parent
// notices nothing.
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <thread>
#include <vector>

#include "ManagerKinds.h"
#include "Runs.h"
#include "threading/process/dxForkListener.h"

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

class ForkCounter final : public dxForkListener {
public:
    ForkCounter() { listenToForks(); }
    ~ForkCounter() { ignoreForks(); }
    void beforeFork() override { ++forks; }
    void inForkedChild() override {}

    int forks = 0;
};

// Whichever of three listeners is removed, the others are notified of forks.
TEST(ForkListener, AnyOfThemMayEnd) {
    for (std::size_t gone = 0; gone < 3; ++gone) {
        std::vector<std::unique_ptr<ForkCounter>> counters(3);
        for (auto &counter : counters) counter = std::make_unique<ForkCounter>();
        counters[gone].reset();
        EXPECT_TRUE(trueInChild([] { return true; }));
        counters[(gone + 1) % 3].reset();
        EXPECT_TRUE(trueInChild([] { return true; }));
        EXPECT_EQ(counters[(gone + 2) % 3]->forks, 2) << gone;
    }
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
