// Whether one thread alone has been stepping with random numbers so far.
//
// A step must take its numbers as one block if another thread could draw in between (contract C7), and for
// that it has to count its rows in advance, which costs two per cent of a small QuickStep. Most programs
// step on one thread, always: its steps may draw one by one, as upstream does, until a second thread comes.
#pragma once

#include "threading/dxStackFrame.h"

class dxLoneStepper {
public:
    // For the time of a step. The first time that a second thread comes, it waits for the step in progress, however long
    // that takes; only where user code in that step (UserCode) has been running for a second, which may be waiting for the
    // second thread or may have left by longjmp, it goes on. (A step with floating-point exceptions trapped counts as such,
    // since their handler may leave it.)
    dxLoneStepper();
    ~dxLoneStepper();
    dxLoneStepper(const dxLoneStepper &) = delete;
    dxLoneStepper &operator=(const dxLoneStepper &) = delete;

    // True: no other thread can be drawing for a step.
    bool alone() const { return m_alone; }

    // Around a moved-callback or a message handler, which may be part of the lone step.
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
