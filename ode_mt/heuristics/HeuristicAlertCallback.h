// Who is told about an alert. The name is the thesis's (figure A.5).
//
// Called by dxHeuristic<T>::tick on the thread that ticks. Inside, everything may be done to the heuristic
// but destroying it (dxHeuristicsManager::remove waits until the tick is over).
#pragma once

class dxHeuristicAlert;
template <class T>
class dxHeuristic;

template <class T>
class HeuristicAlertCallback {
public:
    virtual ~HeuristicAlertCallback() = default;
    virtual void alertCallback(dxHeuristic<T> &heuristic, const dxHeuristicAlert &alert) = 0;
};
