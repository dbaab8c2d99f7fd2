#include "clusters/heuristics/dxGridCentreHeuristic.h"

#include <algorithm>
#include <cmath>

void dxGridCentreHeuristic::forget() {
    m_frame = {};
    m_centre = {};
    m_placed = false;
    m_wantsCentre = false;
    beginRest(kMinRest);
}

void dxGridCentreHeuristic::judge() {
    measure();
    if (!m_placed) {
        m_wantsCentre = true;
        return;
    }
    if (m_wantsCentre || ++m_rested < m_rest) return;
    if (needsMove()) {
        m_wantsCentre = true;
    } else {
        m_rest = kMinRest;
    }
}

void dxGridCentreHeuristic::measure() {
    if (!(m_frame.ns > 0) || !std::isfinite(m_frame.ns)) return;
    m_times.push_back(m_frame.ns);
    m_frame.ns = 0;
    if (m_times.size() < kInterval) return;
    m_cost = dxMedian(m_times);
    if (m_costAtDecision == 0) m_costAtDecision = m_cost;
    m_times.clear();
}

bool dxGridCentreHeuristic::needsMove() const {
    const bool isMoreExpensive = m_costAtDecision > 0 && m_cost > (1 + kDrift) * m_costAtDecision;
    return m_frame.outside > kOutside || isMoreExpensive;
}

bool dxGridCentreHeuristic::farFromCentre(const Point &point, double cellEdge) const {
    for (std::size_t axis = 0; axis < point.size(); ++axis) {
        if (std::abs(point[axis] - m_centre[axis]) > kHysteresis * cellEdge) return true;
    }
    return false;
}

bool dxGridCentreHeuristic::offer(const Point &centre, double cellEdge) {
    if (!wantsCentre()) return false;
    m_wantsCentre = false;
    beginRest(m_placed ? std::min(2 * m_rest, kMaxRest) : kMinRest);
    const auto finite = [](double number) { return std::isfinite(number); };
    if (!std::all_of(centre.begin(), centre.end(), finite)) return false;
    if (!finite(cellEdge) || cellEdge <= 0) return false;
    if (m_placed && !farFromCentre(centre, cellEdge)) return false;
    m_centre = centre;
    m_placed = true;
    return true;
}

void dxGridCentreHeuristic::beginRest(unsigned frames) {
    m_rest = frames;
    m_rested = 0;
    m_times.clear();
    m_cost = m_costAtDecision = 0;
}
