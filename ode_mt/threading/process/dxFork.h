// What the library needs so that a child of fork() can go on with it: listeners, and locks that are held across the fork, so that what they guard is
// whole in the child.
//
// In the child only the thread that forked exists: there are no workers, and a lock that another thread held stays locked.
//
// Order of locks, also while forking: initialisation, creation, the list of dxForkListener, then every dxForkSafeMutex. A thread that holds a
// dxForkSafeMutex takes no other of these.
//
// The handlers are registered with pthread_atfork on behalf of this library; the C library drops them when the library is unloaded.
//
// Threading: any thread.
#pragma once

#include <pthread.h>

#include <atomic>
#include <mutex>

// An object that is notified of fork().
class dxForkListener {
public:
    dxForkListener() = default;
    dxForkListener(const dxForkListener &) = delete;
    dxForkListener &operator=(const dxForkListener &) = delete;

    // Called before the fork, on the thread that forks. Must neither start nor end to listen.
    virtual void beforeFork() {}

    // Called after the fork, in the parent, on that thread.
    virtual void inForkingParent() {}

    // Called in the child, while it has one thread. May touch nothing but memory.
    virtual void inForkedChild() = 0;

protected:
    ~dxForkListener() = default;

    // Called last in the constructor, and first in the destructor, of the class that implements the above, because another thread may fork meanwhile.
    void listenToForks();
    void ignoreForks();

private:
    friend struct dxForkListeners;
    dxForkListener *next = nullptr;
    dxForkListener **link = nullptr;  // what points to this one
};

namespace dxForkLocks {

extern std::recursive_mutex initialisation;  // held by dInitODE and dCloseODE, for their count; recursive, as the user's allocator may call them
extern std::recursive_mutex creation;        // held while a dxProcessObject is made; recursive, as it may make others

}  // namespace dxForkLocks

// A mutex that the child of a fork can use. The thread that forks may hold it, if it forks in the handler of a signal. It then holds it in the child,
// too, and goes on there when the handler has returned.
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
