// fork in the host program: the child has workers again where the manager can give them, the parent
// notices nothing.
//
// Covers dxOpenMPRuntime.cpp.
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <thread>
#include <vector>

#include "ManagerKinds.h"
#include "Runs.h"
#include "threading/pool/dxFutex.h"
#include "threading/process/dxFork.h"

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

bool canBeHeldByAll(dxForkSafeMutex &mutex) {
    std::atomic<bool> isHeld{false};
    std::thread other([&] {
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        isHeld = true;
    });
    const bool can = waitUntil([&] { return isHeld.load(); }, 10);
    if (!can) mutex.unlock();
    other.join();
    return can;
}

// Whoever holds it gives it back first, so that the child finds whole what it guards.
TEST(ForkSafeMutex, IsGivenBackBeforeTheFork) {
    dxForkSafeMutex mutex;
    std::atomic<bool> isHeld{false}, isOver{false};
    int changes = 0;
    std::thread other([&] {
        {
            const std::lock_guard<dxForkSafeMutex> hold(mutex);
            ++changes;
            isHeld = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            ++changes;
        }
        while (!isOver) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    while (!isHeld) std::this_thread::yield();
    EXPECT_TRUE(trueInChild([&] {
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        return changes == 2;
    }));
    isOver = true;
    other.join();
    EXPECT_TRUE(canBeHeldByAll(mutex));
}

// As in the handler of a signal.
TEST(ForkSafeMutex, MayBeHeldByTheThreadThatForks) {
    dxForkSafeMutex mutex;
    mutex.lock();
    const Stopwatch watch;
    EXPECT_TRUE(trueInChild([&] {
        mutex.unlock();
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        return true;
    }));
    EXPECT_LT(watch.seconds(), 0.5) << "nobody is waited for";
    mutex.unlock();
    EXPECT_TRUE(canBeHeldByAll(mutex));
}

// It may wait for the thread that forks.
TEST(ForkSafeMutex, IsNewInTheChildWhereNobodyGivesItBack) {
    dxForkSafeMutex mutex;
    std::atomic<bool> isHeld{false}, isOver{false};
    std::thread other([&] {
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        isHeld = true;
        while (!isOver) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    while (!isHeld) std::this_thread::yield();
    EXPECT_TRUE(trueInChild([&] {
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        return true;
    }));
    isOver = true;
    other.join();
    EXPECT_TRUE(canBeHeldByAll(mutex));
}

TEST(EventCount, WakesWhoWaits) {
    dxForkSafeMutex mutex;
    dxEventCount events;
    bool isSo = false;
    std::thread other([&] {
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        isSo = true;
        events.notify();
    });
    std::unique_lock<dxForkSafeMutex> lock(mutex);
    EXPECT_TRUE(events.waitFor(lock, std::chrono::seconds(30), [&] { return isSo; }));
    EXPECT_FALSE(events.waitFor(lock, std::chrono::milliseconds(1), [] { return false; }));
    lock.unlock();
    other.join();
}

// The child of a handler that forks while the thread waits.
TEST(EventCount, LooksAgainInTheChild) {
    static pid_t child;
    child = -1;
    static dxEventCount events;
    struct sigaction action {}, before;
    action.sa_handler = [](int) {
        child = fork();
        if (child != 0) return;
        alarm(30);
        events.inForkedChild();
    };
    action.sa_flags = SA_RESTART;
    sigaction(SIGUSR1, &action, &before);
    dxForkSafeMutex mutex;
    std::unique_lock<dxForkSafeMutex> lock(mutex);
    std::atomic<bool> isOver{false};
    std::thread other([&, waiting = pthread_self()] {
        {
            const std::lock_guard<dxForkSafeMutex> isWaiting(mutex);
        }
        const auto pause = std::chrono::milliseconds(50);
        std::this_thread::sleep_for(pause);
        pthread_kill(waiting, SIGUSR1);
        std::this_thread::sleep_for(pause);
        {
            const std::lock_guard<dxForkSafeMutex> hold(mutex);
            events.notify();
        }
        isOver = true;
    });
    other.detach();  // the child cannot join it
    while (child < 0) events.wait(lock);
    if (child == 0) _exit(0);
    sigaction(SIGUSR1, &before, nullptr);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    lock.unlock();
    while (!isOver) std::this_thread::yield();
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
