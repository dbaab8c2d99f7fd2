#include "clusters/dxClusterBroadphase.h"

#include <algorithm>
#include <utility>

#include "clusters/dxClusterScene.h"
#include "core/dxLog.h"
#include "core/dxStopwatch.h"
#include "settings/dxSettings.h"

namespace {

// Counting the inhabitants outside the grid visits all dynamic ones.
constexpr unsigned kSearchesBetweenLooks = 16;

// Maximum number of checks that measure no gap, after a gap that did not last until the next search.
constexpr unsigned kMaxBlindChecks = 31;

constexpr dxMotionBound kRest{0, 0, 1, 0};

// Bounds are compared where they were found, so a frame's motion is known, not predicted: no speed, no damping,
// no pose set by the user can make it wrong. The step is one search.
dxMotionBound motionOf(double travel) { return {travel, 0, 1, 0}; }

dxGridCentreHeuristic::Point pointOf(const dReal *v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

}  // namespace

dxClusterBroadphase::dxClusterBroadphase(std::unique_ptr<dxCrossoverPass> pass)
    : m_clusters(std::move(pass)),
      m_cellSize(m_heuristics.add(std::make_unique<dxCellSizeHeuristic>())),
      m_gridCentre(m_heuristics.add(std::make_unique<dxGridCentreHeuristic>())),
      m_crossover(m_heuristics.add(std::make_unique<dxCheckFrequencyHeuristic>())),
      m_declustering(m_heuristics.add(std::make_unique<dxCheckFrequencyHeuristic>())),
      m_threadCount(m_heuristics.add(std::make_unique<dxThreadCountHeuristic>())),
      m_choice(dxNoHeuristics) {
    m_cellSize->setAlertCallback(this);
    m_threadCount->setAlertCallback(this);
}

void dxClusterBroadphase::alertCallback(const dxHeuristic &heuristic, const dxHeuristicAlert &alert) {
    dxLog(dxLogLevel::Debug, "heuristics: %s, %.0f before, %.0f from now on",
          &heuristic == m_cellSize ? "grid cells an axis" : "threads for callbacks", alert.before, alert.now);
}

void dxClusterBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    follow(dxSettings::instance().heuristics());
    const int fixedCells = dxSettings::instance().gridCells();
    m_clusters.setCells(fixedCells != 0 ? fixedCells : m_cellSize->cells());
    const dxStopwatch stopwatch;
    ++m_searches;
    if (mustCheck(members)) check(members);
    m_clusters.findPairs(members, matches);
    tune(stopwatch.ns(), runner.workers());
}

void dxClusterBroadphase::follow(unsigned choice) {
    if (choice == m_choice) return;
    const auto set = [&](dxHeuristic *heuristic, dxHeuristicChoice which) {
        if ((choice & which) != 0) heuristic->start();
        else heuristic->pause();
    };
    set(m_cellSize, dxTuneCells);
    set(m_gridCentre, dxTuneCentre);
    set(m_crossover, dxSkipCrossovers);
    set(m_declustering, dxSkipDeclustering);
    set(m_threadCount, dxTuneThreads);
    m_clusters.setWatchesGrid(!m_gridCentre->running());
    m_choice = choice;
}

bool dxClusterBroadphase::mustCheck(const dxMembers &members) {
    const double travel = m_clusters.travel(members);
    const dxMotionBound motion = motionOf(travel - m_travel);
    m_travel = travel;
    m_crossover->moved(motion);
    m_declustering->moved(motion);
    return m_clusters.wantsGrid() || m_crossover->framesToSkip(kRest) == 0 ||
           (m_clusters.splits() && m_declustering->framesToSkip(kRest) == 0) ||
           m_searches - m_checkedAt > dxCheckFrequencyHeuristic::kMaxFrames;
}

void dxClusterBroadphase::check(const dxMembers &members) {
    const bool gapLasted = m_searches - m_checkedAt > 1;
    ++m_checks;
    m_checkedAt = m_searches;
    m_clusters.check(members);
    m_travel = 0;
    if (gapLasted) m_blindInARow = m_blindChecks = 0;
    if (m_blindChecks > 0) {
        --m_blindChecks;
        m_crossover->invalidate();
        m_declustering->invalidate();
        return;
    }
    if (!gapLasted) m_blindInARow = std::min(2 * m_blindInARow + 1, kMaxBlindChecks);
    m_blindChecks = m_blindInARow;
    measureGaps();
}

void dxClusterBroadphase::measureGaps() {
    const bool skips = m_crossover->running();
    m_crossover->checked(skips ? m_clusters.gapToOthers() : 0);
    m_declustering->checked(skips && m_clusters.splits() ? m_clusters.gapBeforeCut() : 0);
}

void dxClusterBroadphase::tune(double ns, unsigned threads) {
    tuneCells(ns);
    observeCentre(ns);
    m_threadCount->observe(static_cast<unsigned>(m_clusters.clusters().dynamicCount()), threads);
    m_heuristics.tick();
    placeCentre();
}

void dxClusterBroadphase::tuneCells(double ns) {
    if (dxSettings::instance().gridCells() != 0) return;
    const bool climbs = m_cellSize->phase() == dxCellSizeHeuristic::Phase::Climb;  // only the climb needs entities
    const auto entities = static_cast<unsigned>(climbs ? m_clusters.entities() : 0);
    m_cellSize->observe({ns, static_cast<unsigned>(m_clusters.clusters().dynamicCount()), entities});
}

void dxClusterBroadphase::observeCentre(double ns) {
    if (!m_gridCentre->running()) return;
    if (m_searches % kSearchesBetweenLooks == 0) m_shareOutside = dxShareOutside(m_clusters.scene());
    m_gridCentre->observe({m_shareOutside, ns});
}

void dxClusterBroadphase::placeCentre() {
    if (!m_gridCentre->wantsCentre()) return;
    const dxClusterGrid &grid = m_clusters.scene().grid();
    const dxGridCentreHeuristic::Point fitted = pointOf(dxFitGrid(m_clusters.scene(), grid.cells()).centre());
    if (m_gridCentre->offer(fitted, static_cast<double>(grid.edge())) && fitted != pointOf(grid.centre()))
        m_clusters.placeGrid();
}

unsigned dxClusterBroadphase::threads(unsigned limit) const {
    return m_threadCount->running() ? std::min(m_threadCount->threads(), limit) : limit;
}
