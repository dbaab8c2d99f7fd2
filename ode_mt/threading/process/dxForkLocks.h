// Locks that are held across fork, so that the child finds whole what they guard.
//
// Order, also while forking: initialisation, creation, the list of dxForkListener, then every dxForkSafeMutex.
// Under a dxForkSafeMutex no other of these is taken.
#pragma once

#include <pthread.h>

#include <atomic>
#include <mutex>

#include "threading/process/dxForkListener.h"

namespace dxForkLocks {

extern std::recursive_mutex initialisation;  // dInitODE, dCloseODE and what they count; the user's allocator may call them
extern std::recursive_mutex creation;        // a dxProcessObject is being made; it may make others

}  // namespace dxForkLocks

// The thread that forks may hold it: in the handler of a signal that came meanwhile. It holds it in the child, too, and goes on there when the
// handler has returned.
class dxForkSafeMutex final : private dxForkListener {
public:
    dxForkSafeMutex() { listenToForks(); }
    ~dxForkSafeMutex() { ignoreForks(); }

    void lock() {
        m_mutex.lock();
        m_holder.store(pthread_self(), std::memory_order_relaxed);
    }
    void unlock() {
        m_holder.store(pthread_t{}, std::memory_order_relaxed);
        m_mutex.unlock();
    }

private:
    bool isHeldHere() const { return pthread_equal(m_holder.load(std::memory_order_relaxed), pthread_self()); }

    void beforeFork() override;
    void inForkingParent() override;
    void inForkedChild() override;

    std::mutex m_mutex;
    std::atomic<pthread_t> m_holder{};
    bool m_isHeldToFork = false;
};
