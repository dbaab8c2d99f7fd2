// Each worker calls the hooks of its manager once, on its own thread: before its first work and after its last.
#include "threading/pool/dxWorkerThread.h"

#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <mutex>
#include <vector>

#include "Runs.h"
#include "threadSanitizer.h"
#include "threading/managers/dxThreadManagerPthread.h"

namespace {

// What the hooks were called with.
struct Calls {
    struct Of {
        int starts = 0, ends = 0;
        pthread_t thread{};
        bool isSame = true, wasInside = true;
    };

    static void start(void *data, int worker) {
        Calls &calls = *static_cast<Calls *>(data);
        const std::lock_guard<std::mutex> hold(calls.mutex);
        Of &of = calls.workers[worker];
        ++of.starts;
        of.thread = pthread_self();
        of.wasInside = of.wasInside && dxWorkerHooks::isInside();
    }
    static void end(void *data, int worker) {
        Calls &calls = *static_cast<Calls *>(data);
        const std::lock_guard<std::mutex> hold(calls.mutex);
        Of &of = calls.workers[worker];
        ++of.ends;
        of.isSame = of.isSame && pthread_equal(of.thread, pthread_self()) != 0;
        of.wasInside = of.wasInside && dxWorkerHooks::isInside();
    }

    dxWorkerOptions options() {
        dxWorkerOptions result;
        result.hooks = {start, end, this};
        return result;
    }

    std::mutex mutex;
    std::map<int, Of> workers;
};

TEST(WorkerHooks, OnceForEachWorker) {
    Calls calls;
    for (int round = 1; round <= 2; ++round) {
        dxThreadManagerPthread manager(pthread_create, calls.options());
        manager.resize(4);
        ASSERT_TRUE(allWorkersMeet(manager, 4));
        EXPECT_EQ(calls.workers.size(), 3u);
        for (const auto &[worker, of] : calls.workers) EXPECT_EQ(of.starts - of.ends, 1) << worker;
        manager.stop();
        for (const auto &[worker, of] : calls.workers) {
            EXPECT_GE(worker, 1);
            EXPECT_LE(worker, 3);
            EXPECT_EQ(of.starts, round);
            EXPECT_EQ(of.ends, round);
            EXPECT_TRUE(of.isSame);
            EXPECT_TRUE(of.wasInside);
        }
    }
    EXPECT_FALSE(dxWorkerHooks::isInside());
}

TEST(WorkerHooks, TasksAreOutside) {
    Calls calls;
    dxThreadManagerPthread manager(pthread_create, calls.options());
    manager.resize(3);
    std::atomic<int> inside{0};
    Meeting meeting(3);
    runBlocks(manager, 3, 3, [&](unsigned, unsigned) {
        meeting.attend();
        inside += dxWorkerHooks::isInside();
    });
    EXPECT_EQ(inside, 0);
}

TEST(WorkerHooks, EitherMayBeMissing) {
    Calls calls;
    dxWorkerOptions options = calls.options();
    options.hooks.end = nullptr;
    {
        dxThreadManagerPthread manager(pthread_create, options);
        manager.resize(2);
        EXPECT_TRUE(allWorkersMeet(manager, 2));
    }
    EXPECT_EQ(calls.workers[1].starts, 1);
    EXPECT_EQ(calls.workers[1].ends, 0);
    options = calls.options();
    options.hooks.start = nullptr;
    {
        dxThreadManagerPthread manager(pthread_create, options);
        manager.resize(2);
        EXPECT_TRUE(allWorkersMeet(manager, 2));
    }
    EXPECT_EQ(calls.workers[1].starts, 1);
    EXPECT_EQ(calls.workers[1].ends, 1);
}

// A worker that is late in its hook is waited for neither by the run that started it nor by the next.
TEST(WorkerHooks, RunsDoNotWaitForThem) {
    dxWorkerOptions options;
    std::atomic<bool> mayGoOn{false};
    options.hooks = {[](void *data, int) {
                         waitUntil([data] { return static_cast<std::atomic<bool> *>(data)->load(); }, 30);
                     },
                     nullptr, &mayGoOn};
    dxThreadManagerPthread manager(pthread_create, options);
    manager.resize(2);
    const Stopwatch watch;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(everyBlockOnce(manager, 50, 2));
    EXPECT_LT(watch.seconds(), 10);
    mayGoOn = true;
    EXPECT_TRUE(allWorkersMeet(manager, 2));
}

TEST(WorkerHooks, WorkerThatATaskEnds) {
    Calls calls;
    dxThreadManagerPthread manager(pthread_create, calls.options());
    manager.resize(2);
    Meeting meeting(2);
    runBlocks(manager, 2, 2, [&](unsigned, unsigned worker) {
        meeting.attend();
        if (worker == 1) pthread_exit(nullptr);
    });
    EXPECT_TRUE(waitUntil(
        [&] {
            const std::lock_guard<std::mutex> hold(calls.mutex);
            return calls.workers[1].ends == 1;
        },
        10));
    manager.stop();
    EXPECT_EQ(calls.workers[1].ends, 1);
}

TEST(WorkerHooks, ForkedChildCallsThemForItsOwnWorkersAlone) {
    if (underThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer cannot start threads in the child";
    Calls calls;
    dxThreadManagerPthread manager(pthread_create, calls.options());
    manager.resize(3);
    ASSERT_TRUE(allWorkersMeet(manager, 3));
    const pid_t child = fork();
    if (child == 0) {
        alarm(30);
        bool isRight = allWorkersMeet(manager, 3);
        for (int worker = 1; worker <= 2; ++worker) isRight = isRight && calls.workers[worker].starts == 2 && calls.workers[worker].ends == 0;
        manager.stop();
        for (int worker = 1; worker <= 2; ++worker) isRight = isRight && calls.workers[worker].ends == 1;
        _exit(isRight ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    for (const auto &[worker, of] : calls.workers) EXPECT_EQ(of.starts, 1) << worker;
}

}  // namespace
