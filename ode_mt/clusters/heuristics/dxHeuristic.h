// What all heuristics have in common: a state, a tick at the end of every frame, and an alert when they change what they
// tune (thesis, figure A.3).
//
// A heuristic watches numbers that its owner hands in and tunes one parameter of the clustering (thesis 10.1). It may
// change speed, never results.
//
// Threading: none. A heuristic belongs to one (world, space) pair and is used by the thread that runs
// that pair's frame.
#pragma once

#include "clusters/heuristics/dxHeuristicState.h"
#include "clusters/heuristics/HeuristicAlertCallback.h"

class dxHeuristic {
public:
    dxHeuristic() = default;
    dxHeuristic(const dxHeuristic &) = delete;
    dxHeuristic &operator=(const dxHeuristic &) = delete;
    virtual ~dxHeuristic() = default;

    dxHeuristicState state() const { return m_state; }
    bool running() const { return m_state == dxHeuristicState::Running; }

    // False, and nothing happens, where dxMayFollow forbids it.
    bool start() { return change(dxHeuristicState::Running); }  // also after a pause
    bool pause() { return change(dxHeuristicState::Paused); }
    bool stop() { return change(dxHeuristicState::Stopped); }
    bool reset();  // forgets everything; needs a new start

    // The frame is over. False if nothing was done: the heuristic does not run.
    bool tick();

    // From now on `callback` is notified; NULL: none is. It has to outlive the heuristic.
    void setAlertCallback(HeuristicAlertCallback *callback) { m_callback = callback; }

protected:
    // The parameter has been set anew, if the numbers differ.
    void alert(double before, double now) {
        if (m_callback != nullptr && before != now) m_callback->alertCallback(*this, {before, now});
    }

private:
    virtual void judge() = 0;   // a frame, while running
    virtual void forget() = 0;  // back to what it was when created

    bool change(dxHeuristicState to);

    dxHeuristicState m_state = dxHeuristicState::Init;
    HeuristicAlertCallback *m_callback = nullptr;
};
