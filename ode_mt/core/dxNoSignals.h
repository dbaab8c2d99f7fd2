// The calling thread gets no signals while one of these lives, and none that its calls raise meanwhile.
//
// For calls that upstream's functions do not make, on the program's threads: a handler of the program's would run in the middle of another library, and
// writing to a process that has ended raises SIGPIPE, which ends the program. That signal is the calling thread's own: what is pending of it at the end,
// and was not at the beginning, is taken away.
//
// Three calls of the system: 3 us on a virtual machine. Not to be held while user code runs.
#pragma once

#include <signal.h>
#include <time.h>

#include "core/dxBlockedSignals.h"

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
