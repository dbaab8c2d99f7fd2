// Helpers for tests that run tasks on a thread manager.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

#include "threading/dxThreadManager.h"

using BlockFunction = std::function<void(unsigned block, unsigned worker)>;

inline void runBlocks(dxThreadManager &manager, unsigned blocks, unsigned maxWorkers,
                      BlockFunction function) {
    manager.run(
        blocks, maxWorkers,
        [](void *context, unsigned block, unsigned worker) {
            (*static_cast<BlockFunction *>(context))(block, worker);
        },
        &function);
}

// Runs blocks and says whether each ran exactly once. The counters are not atomic on purpose: the
// sanitizer build proves that the caller may read what the workers wrote.
inline bool everyBlockOnce(dxThreadManager &manager, unsigned blocks, unsigned maxWorkers) {
    std::vector<unsigned> times(blocks, 0);
    runBlocks(manager, blocks, maxWorkers, [&](unsigned block, unsigned) { ++times[block]; });
    for (const unsigned count : times) {
        if (count != 1) return false;
    }
    return true;
}

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

private:
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

// Sleeps in small steps until the condition holds; false after `limit` seconds.
template <typename Condition>
bool waitUntil(Condition condition, double limit) {
    const Stopwatch watch;
    while (!condition()) {
        if (watch.seconds() > limit) return false;
        const timespec pause{0, 20000};
        nanosleep(&pause, nullptr);
    }
    return true;
}

// Blocks that wait for each other: complete only if that many threads take part at the same time.
class Meeting {
public:
    explicit Meeting(unsigned expectedThreads) : expected(expectedThreads) {}

    // Waits until all have come, or `limit` seconds.
    void attend(double limit = 30) {
        std::unique_lock<std::mutex> hold(lock);
        if (++arrived == expected) allCame.notify_all();
        allCame.wait_for(hold, std::chrono::duration<double>(limit),
                         [this] { return arrived >= expected || late; });
        if (arrived < expected) late = true;
    }

    bool complete() const { return arrived == expected && !late; }

private:
    const unsigned expected;
    unsigned arrived = 0;
    bool late = false;  // one has given up; the others then do so too
    std::mutex lock;
    std::condition_variable allCame;
};

inline bool allWorkersMeet(dxThreadManager &manager, unsigned workers, double limit = 30) {
    Meeting meeting(workers);
    runBlocks(manager, workers, workers, [&](unsigned, unsigned) { meeting.attend(limit); });
    return meeting.complete();
}
