// The events of one thread: a ring of fixed size, in which a new record replaces the oldest. It also has sums of their times by stage of a frame;
// while statistics are recorded and no trace is, it keeps these alone.
//
// Invariants: record i lies at i modulo kCapacity; records from m_head - kCapacity on are whole, except the one that is being written. A record is a
// cache line of atomic words. The words are released after the head that the record before it has published. So a reader that meets a word of a newer
// record also sees the newer head, and drops what it has read (H.-J. Boehm, "Can seqlocks get along with programming language memory models?", 2012).
//
// Threading: the owner alone writes; any thread may read. A ring is never freed while a thread may write to it.
//
// Dropped: a lock for each ring (a reader would delay the owner); one ring for all threads (its head would be a contended cache line).
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "core/dxCacheLine.h"
#include "threading/timeline/dxTimelineClock.h"
#include "threading/timeline/dxTimelineEvent.h"

// A record as it is read.
struct dxTimelineRecord {
    std::uint64_t begin, end;  // ticks
    const dxTimelineEvent *event;
    std::uint32_t frame;   // number of steps that the caller had made
    std::uint32_t caller;  // the system's number of the thread that called the step or collision
    std::array<std::uint64_t, dxTimelineEvent::kMaxArguments> arguments;
};

class dxTimelineRing {
public:
    static constexpr std::uint64_t kCapacity = 8192;  // records: 512 KiB
    using Arguments = std::array<std::uint64_t, dxTimelineEvent::kMaxArguments>;

    // The thread that a stage is run for, and its frame.
    struct Caller {
        dxTimelineRing *ring;
        std::uint32_t frame;
    };

    // --- for the owner ---

    // The clock, and its last reading: of two events that adjoin one another, only one has to read the clock.
    std::uint64_t readClock() { return m_lastReading = dxTimelineClock::ticks(); }
    std::uint64_t lastReading() const { return m_lastReading; }

    void add(const dxTimelineEvent &event, std::uint64_t begin, std::uint64_t end, const Arguments &arguments = {});

    // The blocks of one run that this thread takes one after the other are one event, with the number of blocks and of the run as arguments.
    std::uint64_t beginBlock(const dxTimelineEvent &event, std::uint64_t run) const;
    // Returns when the block ended.
    std::uint64_t endBlock(const dxTimelineEvent &event, std::uint64_t run, std::uint64_t begin);

    Caller caller() const { return m_caller; }
    void setCaller(const Caller &caller) { m_caller = caller; }
    void becomeCaller() { m_caller = {this, m_frames}; }
    void nextFrame() { m_caller = {this, ++m_frames}; }

    // Counts rows of islands that this thread has solved for its caller. The caller's own need no locked instruction, which would wait for all stores
    // before.
    void countRows(std::uint64_t rows) {
        m_rows += rows;
        if (m_caller.ring != this) m_caller.ring->m_rowsOfWorkers.fetch_add(rows, std::memory_order_relaxed);
    }
    std::uint64_t rows() const { return m_rows; }  // of this thread since it has the ring
    // Returns the number of rows since the last call. Requires that no worker solves islands for this thread.
    std::uint64_t takeRowsOfStep() {
        const std::uint64_t rows = m_rows - m_rowsBefore + m_rowsOfWorkers.load(std::memory_order_relaxed);
        m_rowsBefore = m_rows;
        m_rowsOfWorkers.store(0, std::memory_order_relaxed);
        return rows;
    }

    // Gives back rows that belong to the step around the one that took them.
    void giveRowsBack(std::uint64_t rows) { m_rowsBefore -= rows; }

    void noteThreads(unsigned threads) { m_threads = threads > m_threads ? threads : m_threads; }
    unsigned threads() const { return m_threads; }
    unsigned takeThreads();  // largest number that took part in a run since the last call; at least 1

    // Sums of the events since they were set.
    const dxFrameTimes &times() const { return m_times; }
    void setTimes(const dxFrameTimes &times) { m_times = times; }
    void setTime(dxFrameStage stage, std::uint64_t ticks) { m_times[stage] = ticks; }

    // Collisions of the owner in progress, one within a near-callback of the other.
    unsigned collisionDepth = 0;
    std::uint64_t pairs = 0;  // that they have given to callbacks

    // Of a step that the owner begins, until its dxStepSpan takes it.
    std::uint64_t stepBegin = 0;  // 0: not known
    dxFrameTimes outerTimes{};    // of the step or collision around it, if there is one

    // --- under the lock of the timeline ---

    // Gives the ring to a thread, whose events begin here.
    void own(std::uint32_t thread);
    void forget() { m_first = m_head.load(std::memory_order_acquire); }
    std::uint32_t thread() const { return m_thread.load(std::memory_order_relaxed); }
    std::uint64_t size() const { return m_head.load(std::memory_order_acquire) - m_first; }  // dropped ones included

    // Writes the records that are whole, oldest first. Returns how many older ones have been dropped.
    std::uint64_t read(std::vector<dxTimelineRecord> &records) const;

private:
    enum Word { kBegin, kEnd, kEvent, kFrame, kArguments, kWords = kArguments + dxTimelineEvent::kMaxArguments };
    struct alignas(kCacheLine) Record {
        std::atomic<std::uint64_t> words[kWords];
    };
    static_assert(sizeof(Record) == kCacheLine, "a record is a cache line");

    static void set(std::atomic<std::uint64_t> &word, std::uint64_t value) { word.store(value, std::memory_order_release); }
    bool isLast(const dxTimelineEvent &event, std::uint64_t run) const;
    const Record &last() const { return m_records[(m_head.load(std::memory_order_relaxed) - 1) % kCapacity]; }

    alignas(kCacheLine) std::atomic<std::uint64_t> m_head{0};  // number of records ever written
    Caller m_caller{this, 0};
    std::uint64_t m_lastReading = 0;
    std::uint32_t m_frames = 0;
    unsigned m_threads = 1;
    dxFrameTimes m_times{};
    std::uint64_t m_rows = 0, m_rowsBefore = 0;
    alignas(kCacheLine) std::atomic<std::uint64_t> m_rowsOfWorkers{0};
    std::uint64_t m_first = 0;  // the oldest record that belongs to the trace and the thread
    std::atomic<std::uint32_t> m_thread{0};
    Record m_records[kCapacity];  // not initialised, so that memory is touched as it is used
};
