// What threads wait for that hold a lock: a condition variable whose whole state are two words.
//
// A condition variable of the C library counts the threads that wait, and those of the parent are not in a child of fork(): there it may never be
// used again. This one is used on by the thread that forked, even from the handler of a signal that came while it waited.
//
// Threading: any thread. What is waited for is changed and looked at under the lock.
#pragma once

#include <chrono>
#include <climits>

#include "core/dxGuards.h"
#include "threading/pool/dxFutex.h"

class dxEventCount {
public:
    // Wakes all that wait.
    void notify() {
        ++m_events;
        if (m_sleeping != 0) dxFutexWake(m_events, INT_MAX);
    }

    // Until notify(), or for no reason.
    template <typename Lock>
    void wait(Lock &lock) {
        sleep(lock, [this](std::uint32_t seen) { dxFutexWait(m_events, seen); });
    }

    // For so long at most.
    template <typename Lock>
    void waitFor(Lock &lock, std::chrono::nanoseconds most) {
        sleep(lock, [this, most](std::uint32_t seen) { dxFutexWaitFor(m_events, seen, most); });
    }

    // Until notify() after which it is so; false: it was not so in that time.
    template <typename Lock, typename Condition>
    bool waitFor(Lock &lock, std::chrono::nanoseconds most, Condition isSo) {
        const auto end = std::chrono::steady_clock::now() + most;
        while (!isSo()) {
            const auto left = end - std::chrono::steady_clock::now();
            if (left <= left.zero()) return false;
            waitFor(lock, left);
        }
        return true;
    }

    // In a child of fork(): of those that wait only the thread that forked can be there. It looks again.
    void inForkedChild() { ++m_events; }

private:
    // Counted before the lock is given away: who notifies afterwards sees the thread, or the thread sees the event.
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
    std::atomic<unsigned> m_sleeping{0};  // in a child of fork() too many: waking nobody costs a call
};
