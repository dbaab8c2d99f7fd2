// The clusters of one space and of the world whose bodies its geoms have: grid, pass, clusters and the broad phase by
// clusters (thesis chapters 2 and 5 to 8).
//
// A space owns it through its broad phase (dxClusterBroadphase), which tunes it; alone it is a broad phase without heuristics. Clusters are index
// sets over the space's members; the space and the world stay the user's own.
//
// The cost of a search is that of the changed members, of the crossover pass if one of them changed its cells, and of the clusters
// in which a member changed. Static geoms at rest cost nothing, except under passes that list them. dxClusterBroadphase,
// which knows when a check can be skipped, calls the parts of a search instead.
// Threading: one thread at a time, as the space.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include "clusters/dxClusterGap.h"
#include "clusters/dxClusterScene.h"
#include "clusters/dxClusters.h"
#include "clusters/dxCrossoverPass.h"
#include "clusters/dxInhabitantLinks.h"
#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"

class dxClusteredWorldAndSpace final : public dxBroadphase {
public:
    using Slot = dxMembers::Slot;

    explicit dxClusteredWorldAndSpace(std::unique_ptr<dxCrossoverPass> pass);

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;
    int groupOf(Slot slot) const override;  // the task of its cluster

    // Forgets the changes of clusters in the frame before.
    void beginFrame() { m_history.rest(); }

    // The parts of a search, in this order; check() may be skipped while no member has moved further than the gap
    // allows. Clusters, and everything else below, are then those of the last check.
    //
    // Notes what has changed. Returns the largest distance that a bound of a member has moved since the last check; infinite if
    // a member was added, was removed or changed its kind, or if a joint or a body of theirs changed.
    double travel(const dxMembers &members);
    void check(const dxMembers &members);
    void findPairs(const dxMembers &members, std::vector<Match> &matches);

    // Returns the gap at the last check: no pair is missed while twice the travel is less than this.
    double gapToOthers() { return m_gap.toOthers(m_scene, m_clusters, *m_pass); }
    // Returns the gap of a pass that splits: no cluster can be split before twice the travel reaches it.
    double gapBeforeCut() const { return dxGapBeforeCut(m_scene, m_clusters, m_links.all()); }

    const char *passName() const { return m_pass->name(); }
    bool splits() const { return m_pass->splits(); }
    const dxClusterScene &scene() const { return m_scene; }
    const dxClusters &clusters() const { return m_clusters; }
    const dxClusterHistory &history() const { return m_history; }

    // Returns whether the slot's inhabitant is the one that it had at the last check.
    bool knows(Slot slot, const dxMembers &members) const { return !isAnother(slot, members); }

    // Returns whether, by the last check, the slot's inhabitant is tested with the changed members of that dynamic cluster.
    bool isTestedWith(Slot slot, int cluster) const;

    // Sets the number of cells on each axis from the next check on.
    void setCells(int cells) { m_wantedCells = cells; }
    // Lets the next check place the grid anew.
    void placeGrid() { m_isMisplaced = true; }
    // Sets whether the grid is also placed anew when it is outgrown; true at first.
    void setWatchesGrid(bool watches) { m_watchesGrid = watches; }
    // Returns whether the next check places the grid anew.
    bool wantsGrid() const { return m_isMisplaced || m_wantedCells != m_scene.grid().cells(); }
    // Returns the number of sets of dynamic geoms that belong together: as many as there would be clusters if the cells were small
    // enough (the "entities" of thesis 10.2).
    int entities() const;

private:
    void note(Slot slot);
    bool isAnother(Slot slot, const dxMembers &members) const;
    double travelOf(Slot slot, const dxMembers &members) const;
    void updateScene(const dxMembers &members);
    void updateGrid();
    void gatherLinks(const dxMembers &members);
    void cross();
    void gatherApart();
    void findPairsInCluster(int cluster, const dxMembers &members, std::vector<Match> &matches);
    void findPairsWithAll(Slot slot, const dxMembers &members, std::vector<Match> &matches) const;
    bool isClustered(Slot slot) const;

    std::unique_ptr<dxCrossoverPass> m_pass;
    dxClusterScene m_scene;
    dxClusters m_clusters, m_before;
    dxClusterHistory m_history;
    dxInhabitantLinks m_links;
    dxClusterGap m_gap;
    std::vector<Slot> m_apart;  // tested with every cluster
    std::vector<std::uint64_t> m_arrivals;  // by slot: of the member that was in it at the last check

    // Since the last check.
    std::vector<Slot> m_noted;           // members that changed
    std::vector<std::uint8_t> m_isNoted;  // by slot
    double m_travel = 0;
    bool m_linksChanged = false;

    unsigned m_changesSeen = 0;
    bool m_linksKnown = false;  // they were gathered in this search
    int m_wantedCells;
    bool m_isMisplaced = false, m_watchesGrid = true;
    int m_checksSinceFit = 0;
    bool m_madeAnew = false;  // since the last crossover the grid has been placed anew

    // Of the cluster that is being searched.
    std::vector<Slot> m_listed;
    dxBoxColumns m_boxes;
    std::vector<dxSlotPair> m_together;  // rows
};
