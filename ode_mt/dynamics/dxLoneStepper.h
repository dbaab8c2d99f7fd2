// Whether one thread alone has been stepping with random numbers so far.
//
// A step must take its numbers as one block if another thread could draw in between (contract C7), and for
// that it has to count its rows in advance, which costs two per cent of a small QuickStep. Most programs
// step on one thread, always: its steps may draw one by one, as upstream does, until a second thread comes.
#pragma once

class dxLoneStepper {
public:
    // For the time of a step. The first time that a second thread comes, it waits for the step in progress,
    // but not for ever: user code in that step might be waiting for this one.
    dxLoneStepper();
    ~dxLoneStepper();
    dxLoneStepper(const dxLoneStepper &) = delete;
    dxLoneStepper &operator=(const dxLoneStepper &) = delete;

    // True: no other thread can be drawing for a step.
    bool alone() const { return m_alone; }

private:
    bool m_alone;
    bool m_outermost;  // a callback of a step may step another world
};
