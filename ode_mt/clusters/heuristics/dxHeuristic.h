// What all heuristics have in common: a state, a tick at the end of every search, and an alert when they change what they
// tune (thesis, figure A.3); and the manager that owns the heuristics of one (world, space) pair (figure A.5).
//
// A heuristic watches numbers that its owner hands in and tunes one parameter of the clustering (thesis 10.1). It may
// change speed, never results.
//
// Threading: not thread-safe. Heuristics and their manager belong to one (world, space) pair and are used by the thread that runs that pair's
// frame.
#pragma once

#include <memory>
#include <utility>
#include <vector>

// The states of a heuristic, and which may follow which (thesis, figure A.4, which names the states only).
//
//             start            pause
//   Init ─────────────► Running ─────► Paused      Init     created, has never run
//                       ▲  ▲             │         Reset    as created, waits for its start
//   Reset ──────────────┘  └─────────────┘         Running  takes a sample, or judges, at each tick
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

// Notified when a heuristic changes its parameter. The names are the thesis's (figures A.4 and A.5).
//
// The call comes from within the tick, on its thread. It may change the heuristic's state, but not destroy the heuristic.
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

    // Return false and do nothing where dxMayFollow forbids the change.
    bool start() { return change(dxHeuristicState::Running); }  // also after a pause
    bool pause() { return change(dxHeuristicState::Paused); }
    bool stop() { return change(dxHeuristicState::Stopped); }
    bool reset();  // forgets everything; needs a new start

    // Requires a call at the end of each search. Returns false if nothing was done because the heuristic does not run.
    bool tick();

    // Sets the callback that is notified from now on; NULL: none. It has to outlive the heuristic.
    void setAlertCallback(HeuristicAlertCallback *callback) { m_callback = callback; }

protected:
    // Notifies the callback if the numbers differ.
    void alert(double before, double now) {
        if (m_callback != nullptr && before != now) m_callback->alertCallback(*this, {before, now});
    }

private:
    virtual void judge() = 0;   // called at each tick while running
    virtual void forget() = 0;  // returns to the state of a new object

    bool change(dxHeuristicState to);

    dxHeuristicState m_state = dxHeuristicState::Init;
    HeuristicAlertCallback *m_callback = nullptr;
};

// tick() is called once at the end of every search for pairs. It ticks the heuristics in the order in which they were added, so that alerts come in
// the same order in every run. Unlike the thesis's manager this one knows no heuristic, world or cluster: its owner (dxClusterBroadphase) decides
// what is observed, and acts upon it. There is no global state; several pairs have several managers.
class dxHeuristicsManager {
public:
    template <class Heuristic>
    Heuristic *add(std::unique_ptr<Heuristic> heuristic) {
        Heuristic *const typed = heuristic.get();
        m_heuristics.push_back(std::move(heuristic));
        return typed;
    }

    void tick() {
        for (const std::unique_ptr<dxHeuristic> &heuristic : m_heuristics) heuristic->tick();
    }

private:
    std::vector<std::unique_ptr<dxHeuristic>> m_heuristics;
};

// Returns the median of samples of a heuristic, which outliers (a frame during which the system took the thread off its core) do not move: the lower
// of the two middle numbers if their count is even; 0 if there are none. Requires that no number is NaN. Reorders them.
double dxMedian(std::vector<double> &numbers);
