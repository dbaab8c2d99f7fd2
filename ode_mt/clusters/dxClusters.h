// The clusters of one frame (thesis chapter 2), as index sets: who is in which cluster. Nothing is moved, copied or hidden.
//
// Clusters of dynamic inhabitants come first (numbers 0 to dynamicCount() - 1), clusters of static ones, if
// the pass makes them, behind. Numbers are of this frame; names stay with a cluster from frame to frame.
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
        std::vector<Slot> duplicated;    // static inhabitants that are listed here too
        std::vector<int> staticClusters; // that are tested together with this one ("pseudo-merged")
        unsigned name = 0;               // 0: none; static clusters have none
        int task = 0;                    // clusters of one task are collided one after the other
    };

    void clear(std::size_t slots);
    int addCluster(bool isDynamic);
    void addMember(int cluster, Slot slot);
    // Another inhabitant has the slot, which was in none of these clusters.
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
