// Clusters with the heuristics that tune them: the broad phase of a space under a clustered algorithm.
//
// Before each search the check frequencies decide whether clusters have to be checked again; after it the other heuristics
// observe its time and the number of clusters, and set the parameters of the next one (thesis chapter 10).
// They change speed, never results: docs/clusters.md.
// Threading: one thread at a time, as the space.
#pragma once

#include <memory>

#include "clusters/dxClusteredWorldAndSpace.h"
#include "clusters/heuristics/dxCellSizeHeuristic.h"
#include "clusters/heuristics/dxCheckFrequencyHeuristic.h"
#include "clusters/heuristics/dxGridCentreHeuristic.h"
#include "clusters/heuristics/dxHeuristic.h"
#include "clusters/heuristics/dxThreadCountHeuristic.h"
#include "collision/broadphase/dxBroadphase.h"

class dxClusterBroadphase final : public dxBroadphase, private HeuristicAlertCallback {
public:
    explicit dxClusterBroadphase(std::unique_ptr<dxCrossoverPass> pass);

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;
    int groupOf(dxMembers::Slot slot) const override { return m_clusters.groupOf(slot); }
    unsigned threads(unsigned limit) const override;

    // Requires a call at each frame: a frame in which nothing has changed has no search.
    void beginFrame() { m_clusters.beginFrame(); }

    const dxClusteredWorldAndSpace &clusters() const { return m_clusters; }

    // Return the number of searches, and of those that checked clusters again.
    unsigned searches() const { return m_searches; }
    unsigned checks() const { return m_checks; }

private:
    void alertCallback(const dxHeuristic &heuristic, const dxHeuristicAlert &alert) override;
    void follow(unsigned choice);
    bool mustCheck(const dxMembers &members);
    void check(const dxMembers &members);
    void measureGaps();
    void tune(double ns, unsigned threads);
    void tuneCells(double ns);
    void observeCentre(double ns);
    void placeCentre();

    dxClusteredWorldAndSpace m_clusters;
    dxHeuristicsManager m_heuristics;
    dxCellSizeHeuristic *m_cellSize;  // these are owned by m_heuristics
    dxGridCentreHeuristic *m_gridCentre;
    dxCheckFrequencyHeuristic *m_crossover, *m_declustering;
    dxThreadCountHeuristic *m_threadCount;
    unsigned m_choice;  // of heuristics, in force

    unsigned m_searches = 0, m_checks = 0;
    unsigned m_checkedAt = 0;    // number of the search with the last check
    double m_travel = 0;         // from the last check to the last search
    unsigned m_blindChecks = 0;  // number of checks to come that measure no gap
    unsigned m_blindInARow = 0;  // its value after the last gap that did not last
    double m_shareOutside = 0;   // when it was last counted
};
