// What all heuristics have in common: a state, and a tick at the end of every frame.
//
// A heuristic watches numbers that the frame hands in and tunes one parameter of the clustering (thesis
// 10.1). It may change speed, never results. Two kinds exist: a dxHeuristic<T> keeps a value over time and
// raises alerts; the rules (dxCellSizeHeuristic, ...) turn such numbers into a parameter.
//
// Threading: none. A heuristic belongs to one (world, space) pair and is used by the thread that runs
// that pair's frame.
#pragma once

#include "heuristics/dxHeuristicState.h"

class dxHeuristicBase {
public:
    dxHeuristicBase() = default;
    dxHeuristicBase(const dxHeuristicBase &) = delete;
    dxHeuristicBase &operator=(const dxHeuristicBase &) = delete;
    virtual ~dxHeuristicBase() = default;

    dxHeuristicState state() const { return m_state; }
    bool running() const { return m_state == dxHeuristicState::Running; }

    // False, and nothing happens, where dxMayFollow forbids it.
    bool start() { return change(dxHeuristicState::Running); }  // also after a pause
    bool pause() { return change(dxHeuristicState::Paused); }
    bool stop() { return change(dxHeuristicState::Stopped); }
    bool reset();  // forgets everything but its alerts; needs a new start

    // The frame is over. False if nothing was done: not running, or called from inside this tick.
    bool tick();

private:
    virtual void judge() = 0;   // a frame, while running
    virtual void forget() = 0;  // back to what it was when created

    bool change(dxHeuristicState to);

    dxHeuristicState m_state = dxHeuristicState::Init;
    bool m_ticking = false;
};
