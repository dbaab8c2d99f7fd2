#include "frame/dxTunedClusters.h"

#include <chrono>
#include <utility>

namespace {

using Clock = std::chrono::steady_clock;

double nsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

}  // namespace

dxTunedClusters::dxTunedClusters(std::unique_ptr<dxCrossoverPass> pass)
    : m_clusters(std::move(pass)),
      m_cellSize(m_heuristics.add("cell size", std::make_unique<dxCellSizeHeuristic>())) {
    m_heuristics.startAll();
}

void dxTunedClusters::search(const dxMembers &members, std::vector<Match> &matches) {
    const Clock::time_point start = Clock::now();
    m_clusters.search(members, matches);
    const double ns = nsSince(start);
    const bool climbs = m_cellSize->phase() == dxCellSizeHeuristic::Phase::Climb;  // only then are they asked for
    const auto entities = static_cast<unsigned>(climbs ? m_clusters.entities() : 0);
    m_cellSize->observe({ns, static_cast<unsigned>(m_clusters.clusters().dynamicCount()), entities});
    m_heuristics.tick();
    m_clusters.setCells(m_cellSize->cells());
}
