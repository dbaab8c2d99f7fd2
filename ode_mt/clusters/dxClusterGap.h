// The motion after which unchanged clusters could miss a pair: the bound that allows crossovers to be skipped
// (dxCheckFrequencyHeuristic; thesis 10.1, crossover and declustering frequencies).
//
// Distances are those of boxes: two boxes have the gap g if on some axis there is g between them; they cannot overlap
// before their bounds together have moved by g. Gaps are never overestimated.
//
// Units: metres. Threading: not thread-safe.
#pragma once

#include <vector>

#include "clusters/dxClusterScene.h"
#include "clusters/dxClusters.h"
#include "clusters/dxCrossoverPass.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"

class dxClusterGap {
public:
    // Returns the smallest gap between a dynamic cluster and an inhabitant or cluster with which it is not tested; at most half of the edge of a
    // cell, since only boxes within an edge are examined; infinite if every cluster is tested with everything. 0 may also
    // mean that the gap is not known, because the box around a cluster is measured, not its members.
    double toOthers(const dxClusterScene &scene, const dxClusters &clusters, const dxCrossoverPass &pass);

private:
    using Slot = dxMembers::Slot;

    void gather(const dxClusterScene &scene, const dxClusters &clusters, const dxCrossoverPass &pass);
    double gapOf(int cluster, const dxClusters &clusters, double reach);
    bool isTestedWith(int cluster, std::size_t row, const dxClusters &clusters) const;

    std::vector<dxBounds> m_boxes;  // around each dynamic cluster, then of each static inhabitant
    std::vector<Slot> m_statics;
    dxBoxColumns m_table;  // of m_boxes
    std::vector<std::uint32_t> m_rows;
};

// Returns twice the distance that a member has to move before a cluster that could be split occupies other cells; infinite if no
// cluster could be split. It is compared with twice the travel, as a gap is.
double dxGapBeforeCut(const dxClusterScene &scene, const dxClusters &clusters,
                      const std::vector<dxCrossoverPass::Link> &links);
