// Detects whether a single thread has stepped with random numbers so far.
//
// A step must take its numbers as one block if another thread could draw in between (contract C7), and therefore must
// count its rows in advance, which costs two per cent of a small QuickStep. Most programs step on one thread only: its
// steps may draw one by one, as upstream does, until a second thread steps.
#pragma once

#include "threading/dxStackFrame.h"

class dxSingleStepper {
public:
    // Exists during a step. The first step of a second thread waits for the step in progress, however long that takes;
    // only if user code in that step (UserCode) has been running for a second, which may be waiting for the second
    // thread or may have left by longjmp, it continues. (A step with floating-point exceptions trapped counts as such,
    // since their handler may leave it.)
    dxSingleStepper();
    ~dxSingleStepper();
    dxSingleStepper(const dxSingleStepper &) = delete;
    dxSingleStepper &operator=(const dxSingleStepper &) = delete;

    // Returns whether no other thread can be drawing for a step.
    bool alone() const { return m_alone; }

    // Marks a moved-callback or a message handler, which may be part of the single thread's step.
    class UserCode {
    public:
        UserCode();
        ~UserCode();
        UserCode(const UserCode &) = delete;
        UserCode &operator=(const UserCode &) = delete;

    private:
        bool m_isNoted, m_wasNoted = false;
    };

private:
    bool m_alone;
    bool m_outermost;  // a callback of a step may step another world
};
