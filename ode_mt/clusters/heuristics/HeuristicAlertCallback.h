// Who is told when a heuristic sets its parameter anew. The names are the thesis's (figures A.4 and A.5).
//
// Called on the thread that ticks, within the tick. Inside, the heuristic's state may be changed; it may not be destroyed.
#pragma once

class dxHeuristic;

// The parameter, as a number.
struct dxHeuristicAlert {
    double before, now;
};

class HeuristicAlertCallback {
public:
    virtual void alertCallback(const dxHeuristic &heuristic, const dxHeuristicAlert &alert) = 0;

protected:
    ~HeuristicAlertCallback() = default;
};
