// The recording of what each thread does, for a viewer (docs/tools.md): ODE_MT_TRACE, dODE_MT_StartTrace. And of the same for statistics of
// frames (settings/dxWorldStatistics.h), which need sums alone: it is on where either is wanted.
//
// Each thread has a ring of events (dxTimelineRing), which it gets with its first event and keeps until it ends; the file is written from
// all rings (dxTimelineFile). While nothing is recorded, a place where something would be costs one load and a branch.
//
// Threading: any thread may call any function at any time; start, flush and stop wait for one another, and so does a thread that has its first
// event. After fork the child's trace is over, and its parent's file is left alone; its statistics go on.
#pragma once

#include <atomic>
#include <cstddef>

#include "threading/timeline/dxTimelineRing.h"

class dxTimeline {
public:
    // Null: nothing is recorded, or there is no memory for a ring.
    static dxTimelineRing *ofThisThread() {
        return __builtin_expect(s_state.load(std::memory_order_acquire) == kOff, 1) ? nullptr : findRing();
    }

    // Returns whether nothing is recorded, nor asked for by the environment.
    static bool isOff() { return s_state.load(std::memory_order_relaxed) == kOff; }
    static bool isTraced() { return (s_state.load(std::memory_order_relaxed) & kTraced) != 0; }
    static bool isCounted() { return (s_state.load(std::memory_order_relaxed) & kCounted) != 0; }

    // Statistics are wanted from here on. ODE_MT_LOG and ODE_MT_STATISTICS ask for them, too.
    static void startCounting();

    // These return 0 or an error number of the system.
    static constexpr int kNotRecording = -1;
    static int start(const char *path);
    static int flush();
    static int stop();

    // The file, for messages; cut to the size.
    static void copyPath(char *text, std::size_t size);

    // Async-signal-safe.
    static void requestFlush() { s_flushIsRequested.store(true, std::memory_order_relaxed); }

    // A step begins: what was requested is done.
    static void honourRequest() {
        if (__builtin_expect(s_flushIsRequested.load(std::memory_order_relaxed), 0)) flushAsRequested();
    }

    // Writes the file if something is recorded. Reports an error in the log.
    static void flushAtClose();

    // The same, after which nothing is recorded any more, as the library is about to be unloaded.
    static void unload();

    // For dxTimelineRings.
    static bool isOfThisThread(const dxTimelineRing *ring);
    static void threadEnds(dxTimelineRing *ring);
    static void inForkedChild();

private:
    static constexpr unsigned char kOff = 0, kTraced = 1, kCounted = 2, kUnread = 4;  // unread: the environment

    static dxTimelineRing *findRing();
    static void readEnvironment();
    static void end();
    static void flushAsRequested();

    static std::atomic<unsigned char> s_state;  // bits
    static std::atomic<bool> s_flushIsRequested;
};
