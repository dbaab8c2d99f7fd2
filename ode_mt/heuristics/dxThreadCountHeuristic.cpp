#include "heuristics/dxThreadCountHeuristic.h"

unsigned dxThreadCountHeuristic::threads() const {
    if (!m_enabled || !running() || m_wanted == 0) return m_limit;
    return std::min(m_wanted, m_limit);
}

void dxThreadCountHeuristic::judge() {
    if (!m_enabled) return;
    const unsigned before = threads();
    m_wanted = std::max(m_clusters, 1u);
    if (threads() != before) ++m_changes;
}

void dxThreadCountHeuristic::forget() {
    m_wanted = 0;
    m_changes = 0;
}
