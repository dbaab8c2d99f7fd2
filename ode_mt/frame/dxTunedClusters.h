// Clusters with the heuristics that tune their grid: what a space whose algorithm clusters searches with.
//
// After each search the heuristics see what it took and how many clusters came out, and set the parameters of
// the next one (thesis chapter 10). They change speed, never results: docs/heuristics.md.
// One thread at a time, as the space.
#pragma once

#include <memory>

#include "clustering/dxClusteredWorldAndSpace.h"
#include "collision/dxPairSearch.h"
#include "heuristics/dxCellSizeHeuristic.h"
#include "heuristics/dxHeuristicsManager.h"

class dxTunedClusters final : public dxPairSearch {
public:
    explicit dxTunedClusters(std::unique_ptr<dxCrossoverPass> pass);

    void search(const dxMembers &members, std::vector<Match> &matches) override;

    const dxClusteredWorldAndSpace &clusters() const { return m_clusters; }
    const dxHeuristicsManager &heuristics() const { return m_heuristics; }

private:
    dxClusteredWorldAndSpace m_clusters;
    dxHeuristicsManager m_heuristics;
    dxCellSizeHeuristic *m_cellSize;  // owned by m_heuristics
};
