// The calling thread gets no signals while one of these lives, and threads that it starts meanwhile never do: signals are the program's. Faults are
// their thread's own.
#pragma once

#include <pthread.h>
#include <signal.h>

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
