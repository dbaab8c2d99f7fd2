// What all heuristics have in common: a state, a tick at the end of every frame, and an alert when they change what they
// tune (thesis, figure A.3).
//
// A heuristic watches numbers that its owner hands in and tunes one parameter of the clustering (thesis 10.1). It may
// change speed, never results.
//
// Threading: none. A heuristic belongs to one (world, space) pair and is used by the thread that runs
// that pair's frame.
#pragma once

#include <vector>

// The states of a heuristic, and which may follow which (thesis, figure A.4, which names the states only).
//
//             start            pause
//   Init ─────────────► Running ─────► Paused      Init     created, has never run
//                       ▲  ▲             │         Reset    as created, waits for its start
//   Reset ──────────────┘  └─────────────┘         Running  takes a sample, or judges, once a frame
//     start                    start               Paused   keeps everything, does nothing
//                                                  Stopped  over; what it found can still be read
//   any state ──reset──► Reset
//   any state but Stopped ──stop──► Stopped        nothing returns to Init
enum class dxHeuristicState { Init, Reset, Running, Paused, Stopped };

bool dxMayFollow(dxHeuristicState from, dxHeuristicState to);

class dxHeuristic;

// The parameter, as a number.
struct dxHeuristicAlert {
    double before, now;
};

// Who is told when a heuristic sets its parameter anew. The names are the thesis's (figures A.4 and A.5).
//
// Called on the thread that ticks, within the tick. Inside, the heuristic's state may be changed; it may not be destroyed.
class HeuristicAlertCallback {
public:
    virtual void alertCallback(const dxHeuristic &heuristic, const dxHeuristicAlert &alert) = 0;

protected:
    ~HeuristicAlertCallback() = default;
};

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

// Returns the median of samples of a heuristic, which outliers (a frame during which the system took the thread off its core) do not move: the lower
// of the two middle numbers if their count is even; 0 if there are none. Requires that no number is NaN. Reorders them.
double dxMedian(std::vector<double> &numbers);
