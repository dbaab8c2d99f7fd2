// The clusters of one space and of the world whose bodies its geoms have: grid, pass, clusters and the search
// for pairs by clusters (thesis chapters 2 and 5 to 8).
//
// Belongs to its space, as the space's search for pairs, and goes with it. Clusters are index sets over the
// space's members; the space and the world stay the user's own.
//
// A search costs the changed members, the crossover pass if one of them changed its cells, and the clusters
// in which something changed. Static geoms that rest cost nothing but where a pass says so.
// One thread at a time, as the space.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ode/ode.h>

#include "clustering/dxClusterHistory.h"
#include "clustering/dxClusterScene.h"
#include "clustering/dxClusters.h"
#include "clustering/dxCrossoverPass.h"
#include "clustering/dxInhabitantLinks.h"
#include "collision/dxPairSearch.h"
#include "collision/overlap/dxBoxTable.h"

class dxClusteredWorldAndSpace final : public dxPairSearch {
public:
    explicit dxClusteredWorldAndSpace(std::unique_ptr<dxCrossoverPass> pass);

    void search(const dxMembers &members, std::vector<Match> &matches) override;

    const char *passName() const { return m_pass->name(); }
    const dxClusterScene &scene() const { return m_scene; }
    const dxClusters &clusters() const { return m_clusters; }
    const dxClusterHistory &history() const { return m_history; }

    // Cells an axis, at the next search.
    void setCells(int cells) { m_wantedCells = cells; }
    // Sets of dynamic geoms that belong together: as many as there could be clusters, were the cells small
    // enough (the "entities" of thesis 10.2).
    int entities() const;

private:
    using Slot = dxMembers::Slot;

    void updateScene(const dxMembers &members);
    void updateGrid();
    void cross();
    void gatherApart();
    void searchCluster(int cluster, const dxMembers &members, std::vector<Match> &matches);
    void searchWithAll(Slot slot, const dxMembers &members, std::vector<Match> &matches) const;
    bool isClustered(Slot slot) const;

    std::unique_ptr<dxCrossoverPass> m_pass;
    dxClusterScene m_scene;
    dxClusters m_clusters, m_before;
    dxClusterHistory m_history;
    dxInhabitantLinks m_links;
    std::vector<Slot> m_apart;  // tested with every cluster
    unsigned m_changesSeen = 0;
    int m_wantedCells;
    int m_searchesSinceFit = 0;
    bool m_madeAnew = false;  // since the last crossover the grid has been placed anew

    // Of the cluster that is being searched.
    std::vector<Slot> m_listed;
    dxBoxTable m_boxes;
    std::vector<std::uint32_t> m_rows;
};
