// Sleeping until another thread wakes this one: on a 32-bit word (Linux futex, private to the process), and a condition variable made of two such
// words.
//
// A condition variable of the C library counts the threads that wait, and those of the parent do not exist in a child of fork(): there it may never
// be used again. The thread that forked goes on using dxEventCount, even from the handler of a signal that came while it waited.
//
// Threading: any thread.
#pragma once

#include <atomic>
#include <chrono>
#include <climits>
#include <cstdint>

#include "core/dxGuards.h"

using dxFutexWord = std::atomic<std::uint32_t>;

// Sleeps while the word holds `expected`. May return early: the caller checks its condition again.
void dxFutexWait(dxFutexWord &word, std::uint32_t expected);

// The same for this time at most. Returns false if it has passed.
bool dxFutexWaitFor(dxFutexWord &word, std::uint32_t expected, std::chrono::nanoseconds most);

// Wakes up to `count` sleepers. The word may already belong to another object: waking accesses no memory.
void dxFutexWake(dxFutexWord &word, unsigned count);

// What threads wait for that hold a lock. The condition is changed and tested under the lock.
class dxEventCount {
public:
    // Wakes all that wait.
    void notify() {
        ++m_events;
        if (m_sleeping != 0) dxFutexWake(m_events, INT_MAX);
    }

    // Waits until notify(). May return early.
    template <typename Lock>
    void wait(Lock &lock) {
        sleep(lock, [this](std::uint32_t seen) { dxFutexWait(m_events, seen); });
    }

    // The same for this time at most.
    template <typename Lock>
    void waitFor(Lock &lock, std::chrono::nanoseconds most) {
        sleep(lock, [this, most](std::uint32_t seen) { dxFutexWaitFor(m_events, seen, most); });
    }

    // Waits until the condition holds. Returns false if it did not in that time.
    template <typename Lock, typename Condition>
    bool waitFor(Lock &lock, std::chrono::nanoseconds most, Condition condition) {
        const auto end = std::chrono::steady_clock::now() + most;
        while (!condition()) {
            const auto left = end - std::chrono::steady_clock::now();
            if (left <= left.zero()) return false;
            waitFor(lock, left);
        }
        return true;
    }

    // Called in a child of fork(). Of the threads that wait only the one that forked can exist: it tests its condition again.
    void inForkedChild() { ++m_events; }

private:
    // Counts the thread before it unlocks: a thread that notifies afterwards sees it, or it sees the event.
    template <typename Lock, typename Wait>
    void sleep(Lock &lock, Wait wait) {
        ++m_sleeping;
        const std::uint32_t seen = m_events;
        {
            const dxUnlocked others(lock);
            wait(seen);
        }
        --m_sleeping;
    }

    dxFutexWord m_events{0};
    std::atomic<unsigned> m_sleeping{0};  // too many in a child of fork(), where waking none costs a call
};
