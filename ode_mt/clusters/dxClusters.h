// The clusters of one frame (thesis chapter 2) as index sets, and what happened to clusters from one frame to the next: names that stay, merges
// (thesis chapter 2) and splits (chapter 8). Nothing is moved, copied or hidden.
//
// Clusters of dynamic inhabitants have the numbers 0 to dynamicCount() - 1; clusters of static ones, if the pass makes them, follow. Numbers are
// valid in one frame; names stay with a cluster from frame to frame.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"

class dxClusters {
public:
    using Slot = dxMembers::Slot;
    static constexpr int kNone = -1;

    struct Cluster {
        std::vector<Slot> members;
        std::vector<Slot> duplicated;     // static inhabitants that are listed here too
        std::vector<int> staticClusters;  // tested together with this one ("pseudo-merged")
        unsigned name = 0;                // 0: none; static clusters have none
        int task = 0;                     // clusters of one task are collided one after the other
    };

    void clear(std::size_t slots);
    int addCluster(bool isDynamic);
    void addMember(int cluster, Slot slot);
    // Requires a call when another inhabitant gets the slot: it is in none of these clusters.
    void forgetMember(Slot slot) {
        if (slot < m_of.size()) m_of[slot] = kNone;
    }

    int count() const { return m_count; }
    int dynamicCount() const { return m_dynamicCount; }
    Cluster &operator[](int cluster) { return m_clusters[cluster]; }
    const Cluster &operator[](int cluster) const { return m_clusters[cluster]; }
    int of(Slot slot) const { return slot < m_of.size() ? m_of[slot] : kNone; }

private:
    std::vector<Cluster> m_clusters;  // the first m_count; the others keep their memory
    std::vector<int> m_of;            // by slot
    int m_count = 0, m_dynamicCount = 0;
};

struct dxClusterChange {
    enum class Kind { merge, split };
    Kind kind;
    unsigned from, into;  // names. Merge: `from` became part of `into`; split: `into` came off `from`
};

class dxClusterHistory {
public:
    // Names the dynamic clusters of `now`. Shares of members are taken from the largest on: a cluster gets the name of the cluster of `before` if
    // neither has been matched yet. A cluster without a match gets a new name. Names are never reused. Requires clusters that were added since
    // clear().
    void follow(const dxClusters &before, dxClusters &now);
    // Requires a call when a search begins, and in a frame without one.
    void rest() { m_changes.clear(); }

    // Returns the changes of the last search.
    const std::vector<dxClusterChange> &changes() const { return m_changes; }
    // Return the numbers of merges and splits since the start.
    unsigned merges() const { return m_merges; }
    unsigned splits() const { return m_splits; }

private:
    struct Share {
        int now, before;
        int members;
    };

    void gatherShares(const dxClusters &before, const dxClusters &now);
    void report(dxClusterChange::Kind kind, unsigned from, unsigned into);

    std::vector<Share> m_shares;
    std::vector<dxClusterChange> m_changes;
    std::vector<std::uint8_t> m_nameIsTaken;  // of the cluster before
    std::vector<int> m_counts, m_touched;     // of the cluster now: members by the cluster before
    unsigned m_nextName = 1, m_merges = 0, m_splits = 0;
};
