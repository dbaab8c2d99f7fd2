// Guards around calls that upstream's functions do not make, on the program's threads: each changes what may happen to the calling thread in its
// scope, and puts it back at its end.
//
//   dxNoCancellation    pthread_cancel does not end the thread
//   dxBlockedSignals    no signals but faults
//   dxNoSignals         likewise, and no SIGPIPE of its own calls afterwards
//   dxUndisturbed       the first and the third, and errno is unchanged
//   dxUnlocked          a lock is free
//
// None may be held while user code runs, but for dxUnlocked.
#pragma once

#include <pthread.h>
#include <signal.h>
#include <time.h>

#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>

// Upstream has no cancellation point in what it computes: a request stays pending until the program's own next one. Ours joins threads and sleeps,
// which are cancellation points, often where an object is destroyed, out of which nothing may unwind.
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

// Sleeps for a moment, while others go on. No cancellation point.
inline void dxSleep(std::chrono::microseconds time) {
    const dxNoCancellation whole;
    std::this_thread::sleep_for(time);
}

// Threads that are started meanwhile never get signals: these are the program's. Faults are their thread's own.
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

// For calls of another library: a handler of the program's would run in the middle of it, and writing to a process that has ended raises
// SIGPIPE, which ends the program. That signal is the calling thread's own: what is pending of it at the end, and was not at the beginning, is
// taken away.
//
// Three calls of the system: 3 us on a virtual machine.
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

// Around what a step of upstream's has none of: points where a thread is cancelled, signals, changes of errno.
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
