// Locks that are held across fork, so that the child finds whole what they guard.
//
// Order, also while forking: initialisation, creation, the list of dxForkListener, then every dxForkSafeMutex.
// Under a dxForkSafeMutex no other lock is taken.
#pragma once

#include <mutex>

#include "threading/process/dxForkListener.h"

namespace dxForkLocks {

extern std::recursive_mutex initialisation;  // dInitODE, dCloseODE and what they count; the user's allocator may call them
extern std::recursive_mutex creation;        // a dxProcessObject is being made; it may make others

}  // namespace dxForkLocks

class dxForkSafeMutex final : private dxForkListener {
public:
    dxForkSafeMutex() { listenToForks(); }
    ~dxForkSafeMutex() { ignoreForks(); }

    void lock() { m_mutex.lock(); }
    void unlock() { m_mutex.unlock(); }

private:
    void beforeFork() override { m_mutex.lock(); }
    void inForkingParent() override { m_mutex.unlock(); }
    void inForkedChild() override { m_mutex.unlock(); }

    std::mutex m_mutex;
};
