// The motion after which unchanged clusters could miss a pair: the bound that allows crossovers to be skipped
// (dxCheckFrequencyHeuristic; thesis 10.1, crossover and declustering frequencies).
//
// Distances are those of boxes: two boxes are g apart if on some axis g lies between them; they cannot overlap
// before their bounds have moved by g together. Gaps are never too large. Metres. Not thread safe.
#pragma once

#include <vector>

#include "clusters/dxClusterScene.h"
#include "clusters/dxClusters.h"
#include "clusters/dxCrossoverPass.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"

class dxClusterGap {
public:
    // The smallest gap between a dynamic cluster and something with which it is not tested; at most about a
    // cell, as nothing is looked for further away; infinite if every cluster is tested with everything. 0 also
    // means: not known, as the box around a cluster is measured, not its members.
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

// How far a member has to move before a cluster that could be cut in two occupies other cells; infinite if no
// cluster could be.
double dxGapBeforeCut(const dxClusterScene &scene, const dxClusters &clusters,
                      const std::vector<dxCrossoverPass::Link> &links);
