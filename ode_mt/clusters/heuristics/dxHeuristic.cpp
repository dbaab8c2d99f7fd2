#include "clusters/heuristics/dxHeuristic.h"

#include <algorithm>
#include <cstddef>

bool dxMayFollow(dxHeuristicState from, dxHeuristicState to) {
    switch (to) {
        case dxHeuristicState::Init:
            return false;
        case dxHeuristicState::Reset:
            return true;
        case dxHeuristicState::Running:
            return from != dxHeuristicState::Running && from != dxHeuristicState::Stopped;
        case dxHeuristicState::Paused:
            return from == dxHeuristicState::Running;
        case dxHeuristicState::Stopped:
            return from != dxHeuristicState::Stopped;
    }
    return false;
}

bool dxHeuristic::change(dxHeuristicState to) {
    if (!dxMayFollow(m_state, to)) return false;
    m_state = to;
    return true;
}

bool dxHeuristic::reset() {
    if (!change(dxHeuristicState::Reset)) return false;
    forget();
    return true;
}

bool dxHeuristic::tick() {
    if (!running()) return false;
    judge();
    return true;
}

double dxMedian(std::vector<double> &numbers) {
    if (numbers.empty()) return 0;
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>((numbers.size() - 1) / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}
