#include "clusters/heuristics/dxThreadCountHeuristic.h"

unsigned dxThreadCountHeuristic::threads() const {
    if (!running() || m_wanted == 0) return m_limit;
    return std::min(m_wanted, m_limit);
}

void dxThreadCountHeuristic::judge() {
    const unsigned before = threads();
    m_wanted = std::max(m_clusters, 1u);
    alert(before, threads());
}

void dxThreadCountHeuristic::forget() {
    m_wanted = 0;
}
