#include "heuristics/dxHeuristicBase.h"

#include "heuristics/dxScopedFlag.h"

bool dxHeuristicBase::change(dxHeuristicState to) {
    if (!dxMayFollow(m_state, to)) return false;
    m_state = to;
    return true;
}

bool dxHeuristicBase::reset() {
    if (!change(dxHeuristicState::Reset)) return false;
    forget();
    return true;
}

bool dxHeuristicBase::tick() {
    if (!running() || m_ticking) return false;
    const dxScopedFlag ticking(m_ticking);
    judge();
    return true;
}
