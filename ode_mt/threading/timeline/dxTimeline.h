// Records what each thread does, for a viewer (ODE_MT_TRACE, dODE_MT_StartTrace; docs/tools.md), and for statistics of frames
// (settings/dxWorldStatistics.h), which need sums alone. It records where either is wanted.
//
// Each thread has a ring of events (dxTimelineRing), which it gets with its first event and keeps until it ends. The file (dxTimelineFile) is written
// from all rings. Rings of threads that have ended keep their events until kKeptRings threads have come; then they are given to new ones, the oldest
// first. While nothing is recorded, a place that would record costs one load and a branch.
//
// Threading: any thread may call any function at any time. Start, flush and stop wait for one another, and so does a thread that has its first event:
// one lock is held for all of that, also while the file is written, and across fork. In a child of fork the trace has ended, and the parent's file is
// unchanged; statistics continue.
#pragma once

#include <atomic>
#include <cstddef>

#include "threading/timeline/dxTimelineRing.h"

class dxTimeline {
public:
    // Returns null if nothing is recorded, or there is no memory for a ring.
    static dxTimelineRing *ofThisThread() {
        return __builtin_expect(s_state.load(std::memory_order_acquire) == kOff, 1) ? nullptr : findRing();
    }

    // Returns whether nothing is recorded, and the environment asks for nothing.
    static bool isOff() { return s_state.load(std::memory_order_relaxed) == kOff; }
    static bool isTraced() { return (s_state.load(std::memory_order_relaxed) & kTraced) != 0; }
    static bool isCounted() { return (s_state.load(std::memory_order_relaxed) & kCounted) != 0; }
    // Returns whether statistics are recorded, or may be: until the first event, it is not known what the environment asks for.
    static bool mayBeCounted() { return (s_state.load(std::memory_order_relaxed) & (kCounted | kUnread)) != 0; }

    // Records for statistics from here on. ODE_MT_LOG and ODE_MT_STATISTICS ask for that, too.
    static void startCounting();

    // These return 0 or an error number of the system.
    static constexpr int kNotRecording = -1;
    static int start(const char *path);
    static int flush();
    static int stop();

    // Copies the path of the file, for messages; cut to the size.
    static void copyPath(char *text, std::size_t size);

    // Async-signal-safe.
    static void requestFlush() { s_flushIsRequested.store(true, std::memory_order_relaxed); }

    // Called when a step begins: writes the file if that was requested.
    static void honourRequest() {
        if (__builtin_expect(s_flushIsRequested.load(std::memory_order_relaxed), 0)) flushAsRequested();
    }

private:
    friend class dxTimelineRings;

    static constexpr unsigned char kOff = 0, kTraced = 1, kCounted = 2, kUnread = 4;  // unread: the environment

    static dxTimelineRing *findRing();
    // Starts what the environment asks for. `tracePath`: of the trace to start, null: none.
    static void readEnvironment(const char *tracePath);
    static void end();
    static void flushAsRequested();

    // Writes the file if something is recorded. Reports an error in the log.
    static void flushAtClose();

    static std::atomic<unsigned char> s_state;  // bits
    static std::atomic<bool> s_flushIsRequested;
};

// An event of the calling thread from here to the end of the scope. A longjmp out of the scope leaves no event.
class dxTimelineSpan {
public:
    // Where it begins: now, or where the last event of this thread began or ended, just before.
    enum class Begin { Now, Adjoining };

    explicit dxTimelineSpan(const dxTimelineEvent &event, bool isWanted = true, Begin begin = Begin::Now)
        : m_event(event), m_ring(isWanted ? dxTimeline::ofThisThread() : nullptr) {
        if (m_ring == nullptr) return;
        m_begin = begin == Begin::Now ? m_ring->readClock() : m_ring->lastReading();
        m_arguments = {};
    }
    ~dxTimelineSpan() {
        if (m_ring != nullptr) m_ring->add(m_event, m_begin, m_endsAdjoining ? m_ring->lastReading() : m_ring->readClock(), m_arguments);
    }
    dxTimelineSpan(const dxTimelineSpan &) = delete;
    dxTimelineSpan &operator=(const dxTimelineSpan &) = delete;

    dxTimelineRing *ring() const { return m_ring; }  // null: nothing is recorded
    void endAdjoining() { m_endsAdjoining = true; }  // where the last event within it has ended, just before
    void set(unsigned argument, std::uint64_t value) {
        if (m_ring != nullptr) m_arguments[argument] = value;
    }

private:
    const dxTimelineEvent &m_event;
    dxTimelineRing *const m_ring;
    bool m_endsAdjoining = false;
    std::uint64_t m_begin;  // is set, as the arguments are, if something is recorded
    dxTimelineRing::Arguments m_arguments;
};
