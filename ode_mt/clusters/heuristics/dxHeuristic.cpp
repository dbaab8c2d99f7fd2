#include "clusters/heuristics/dxHeuristic.h"

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
