// Guards around calls that upstream's functions do not make, on the program's threads: each changes what may happen to the calling thread in its
// scope, and restores that at its end.
//
//   dxNoCancellation    pthread_cancel does not end the thread
//   dxBlockedSignals    no signals but faults
//   dxNoSignals         no signals but faults, and no SIGPIPE of the thread's own calls afterwards
//   dxUndisturbed       dxNoCancellation and dxNoSignals, and errno is unchanged
//   dxUnlocked          a lock is free
//
// Only dxUnlocked may exist while user code runs.
//
// Threading: each changes the calling thread alone.
#pragma once

#include <pthread.h>
#include <signal.h>
#include <time.h>

#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>

// Upstream computes without cancellation points: a request stays pending until the program's own next one. Our code joins threads and sleeps,
// which are cancellation points, often in destructors, out of which nothing may unwind.
class dxNoCancellation {
public:
    dxNoCancellation() { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &m_before); }
    ~dxNoCancellation() {
        int ours;
        pthread_setcancelstate(m_before, &ours);
    }
    dxNoCancellation(const dxNoCancellation &) = delete;
    dxNoCancellation &operator=(const dxNoCancellation &) = delete;

private:
    int m_before = PTHREAD_CANCEL_ENABLE;
};

// Sleeps for this time. No cancellation point.
inline void dxSleep(std::chrono::microseconds time) {
    const dxNoCancellation whole;
    std::this_thread::sleep_for(time);
}

// Threads that are started in the scope never get signals, which belong to the program. Faults are their thread's own.
class dxBlockedSignals {
public:
    dxBlockedSignals() {
        sigset_t blocked;
        sigfillset(&blocked);
        for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT}) sigdelset(&blocked, fault);
        pthread_sigmask(SIG_SETMASK, &blocked, &m_before);
    }
    ~dxBlockedSignals() { pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }
    dxBlockedSignals(const dxBlockedSignals &) = delete;
    dxBlockedSignals &operator=(const dxBlockedSignals &) = delete;

    bool wasBlocked(int signal) const { return sigismember(&m_before, signal) == 1; }

private:
    sigset_t m_before;
};

// For calls of another library: a handler of the program's would run in the middle of them, and writing to a process that has ended raises
// SIGPIPE, which ends the program. That signal belongs to the calling thread: one that is pending at the end, and was not at the beginning, is
// removed.
//
// It makes three system calls: 3 us on a virtual machine.
class dxNoSignals {
public:
    dxNoSignals() : m_wasPending(m_blocked.wasBlocked(SIGPIPE) && isPending()) {}
    ~dxNoSignals() {
        if (m_wasPending || !isPending()) return;
        sigset_t pipe;
        sigemptyset(&pipe);
        sigaddset(&pipe, SIGPIPE);
        const timespec now{};
        sigtimedwait(&pipe, nullptr, &now);
    }
    dxNoSignals(const dxNoSignals &) = delete;
    dxNoSignals &operator=(const dxNoSignals &) = delete;

private:
    static bool isPending() {
        sigset_t pending;
        sigemptyset(&pending);
        sigpending(&pending);
        return sigismember(&pending, SIGPIPE) == 1;
    }

    const dxBlockedSignals m_blocked;
    const bool m_wasPending;
};

// For calls within a step: upstream's step has no cancellation points, gets no signals from its own calls, and does not change errno.
class dxUndisturbed {
public:
    dxUndisturbed() = default;
    ~dxUndisturbed() { errno = m_error; }
    dxUndisturbed(const dxUndisturbed &) = delete;
    dxUndisturbed &operator=(const dxUndisturbed &) = delete;

private:
    const int m_error = errno;
    const dxNoCancellation m_whole;
    const dxNoSignals m_none;
};

// Unlocks for the scope; locks again at its end.
template <typename Mutex>
class dxUnlocked {
public:
    explicit dxUnlocked(std::unique_lock<Mutex> &lock) : m_lock(lock) { m_lock.unlock(); }
    ~dxUnlocked() { m_lock.lock(); }
    dxUnlocked(const dxUnlocked &) = delete;
    dxUnlocked &operator=(const dxUnlocked &) = delete;

private:
    std::unique_lock<Mutex> &m_lock;
};
