#include "clusters/heuristics/dxCellSizeHeuristic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double kLeftEarly = std::numeric_limits<double>::infinity();

bool measured(double ns) { return ns > 0 && std::isfinite(ns); }

bool drifted(double cost, double since) {
    return std::abs(cost - since) > dxCellSizeHeuristic::kDrift * since;
}

}  // namespace

double dxCellSizeHeuristic::cost(int cells) const {
    if (cells < kMinCells || cells > kMaxCells) return 0;
    return m_cost[static_cast<std::size_t>(cells - kMinCells)];
}

void dxCellSizeHeuristic::forget() {
    m_frame = {};
    m_phase = Phase::Climb;
    m_cost = {};
    m_expensiveInARow = 0;
    m_hold = kMinHold;
    m_moved = false;
    use(kMinCells);
    m_newGrid = true;
}

void dxCellSizeHeuristic::judge() {
    const double ns = m_frame.ns;
    m_frame.ns = 0;
    if (!measured(ns)) return;
    if (m_newGrid) {
        m_newGrid = false;
        return;
    }
    m_times.push_back(ns);
    const double median = dxMedian(m_times);
    const bool early = tooExpensive(median);
    if (!early && m_times.size() < m_interval) return;

    m_times.clear();
    const double cost = early ? kLeftEarly : median;
    costOf(m_cells) = cost;
    if (m_phase == Phase::Climb) return endClimbingStep(cost);
    if (m_phase == Phase::Hold) return endHolding(cost);
    endProbe();
}

bool dxCellSizeHeuristic::tooExpensive(double median) const {
    if (m_phase == Phase::Hold || m_times.size() < kTrialFrames) return false;
    const double best = cheapestCost();
    return best > 0 && median > kTooExpensive * best;
}

// While probing, the costs of numbers other than the one that was held are out of date. Returns 0 if there is none yet.
double dxCellSizeHeuristic::cheapestCost() const {
    return m_phase == Phase::Climb ? cost(cheapest()) : cost(m_home);
}

// Returns the smallest of several numbers that cost the same.
int dxCellSizeHeuristic::cheapest() const {
    int best = kMinCells;
    for (int cells = kMinCells + 1; cells <= kMaxCells; ++cells) {
        if (cost(cells) > 0 && cost(cells) < cost(best)) best = cells;
    }
    return best;
}

void dxCellSizeHeuristic::endClimbingStep(double cost) {
    m_expensiveInARow = cost == kLeftEarly ? m_expensiveInARow + 1 : 0;
    const bool separated = m_frame.entities > 0 && m_frame.clusters >= m_frame.entities;
    if (separated || m_cells == kMaxCells || m_expensiveInARow == 2) {
        hold(cheapest(), kMinHold);
    } else {
        use(m_cells + 1);
    }
}

void dxCellSizeHeuristic::endHolding(double cost) {
    if (++m_held < m_hold || !(m_moved || drifted(cost, m_chosenCost))) return;
    m_phase = m_home > kMinCells ? Phase::ProbeBelow : Phase::ProbeAbove;
    use(m_home > kMinCells ? m_home - 1 : m_home + 1);
}

void dxCellSizeHeuristic::endProbe() {
    if (m_phase == Phase::ProbeBelow && m_home < kMaxCells) {
        m_phase = Phase::ProbeAbove;
        use(m_home + 1);
    } else {
        endProbing();
    }
}

void dxCellSizeHeuristic::endProbing() {
    const int below = std::max(m_home - 1, kMinCells), above = std::min(m_home + 1, kMaxCells);
    const int better = cost(below) <= cost(above) ? below : above;
    m_moved = cost(better) < kClearGain * cost(m_home);
    if (m_moved) {
        hold(better, kMinHold);
    } else {
        hold(m_home, std::min(2 * m_hold, kMaxHold));
    }
}

void dxCellSizeHeuristic::hold(int cells, unsigned intervals) {
    m_phase = Phase::Hold;
    m_home = cells;
    m_chosenCost = cost(cells);
    m_hold = intervals;
    m_held = 0;
    use(cells);
}

void dxCellSizeHeuristic::use(int cells) {
    const int before = m_cells;
    m_newGrid = cells != before;
    m_cells = cells;
    m_times.clear();
    alert(before, cells);
}
