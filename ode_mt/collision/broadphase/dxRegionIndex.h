// Queries of the members of a space that overlap a given box: for rays, sensors, and other geoms that are tested
// against a whole space.
//
// Members at rest are in a BVH (overlap/dxBoxBvh.h). A member that changes becomes loose, and is compared with every
// queried box, with SIMD. At first all are loose. The tree is rebuilt when the comparisons of loose members have cost as much as building it
// does. So a space without queries builds none, and in one with many queries, with or without motion, a query has
// logarithmic cost.
//
// Threading: several threads may query while no member changes. One of them builds the tree, the others compare all
// members meanwhile. No thread waits, so none can wait for a thread that does not exist after fork. The result is in
// memory of the querying thread; no lock is held when find() returns.
#pragma once

#include <atomic>
#include <memory_resource>
#include <shared_mutex>
#include <vector>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/overlap/dxBoxBvh.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/pairs/dxMembers.h"
#include "core/dxNoIndex.h"
#include "core/dxRadixSort.h"

class dxRegionIndex {
public:
    using Slot = dxMembers::Slot;

    // Requires a call when a member is new or has changed, with its box. Does nothing before the first query. Without memory the tree
    // is discarded until it is rebuilt.
    void loosen(Slot slot, const dxBounds &box) noexcept;
    // Requires a call when a member is removed. Does nothing before the first query.
    void drop(Slot slot);

    // Fills `found` with the members whose boxes overlap `box`, the one furthest to the front of the list
    // first.
    void find(const dxMembers &members, const dxBounds &box, std::pmr::vector<Slot> &found);

    // Requires a call after each query, here or by comparing all members, with the number of members found and of all.
    void noteFound(std::size_t found, std::size_t all) {
        const bool isSelective = dxBroadphaseThresholds::kMinUnmetPerMet * found <= all;
        if (isSelective != m_isSelective.load(std::memory_order_relaxed)) m_isSelective.store(isSelective, std::memory_order_relaxed);
        const bool isHighly = dxBroadphaseThresholds::kMinUnmetPerMetWithSimd * found <= all;
        if (isHighly != m_isHighlySelective.load(std::memory_order_relaxed)) m_isHighlySelective.store(isHighly, std::memory_order_relaxed);
    }
    // Returns whether the last query found so few members that comparing all one by one would have taken longer.
    bool isSelective() const { return m_isSelective.load(std::memory_order_relaxed); }
    // Returns the same for comparing all with SIMD.
    bool isHighlySelective() const { return m_isHighlySelective.load(std::memory_order_relaxed); }

private:
    struct Place {
        std::uint32_t row = kNoIndex;    // in the tree
        std::uint32_t loose = kNoIndex;  // place in m_loose
    };

    Place &placeOf(Slot slot);
    void joinLoose(Slot slot, const dxBounds &box);
    bool begin(const dxMembers &members);
    void appendLoose(const dxBounds &box, std::pmr::vector<Slot> &found) const;
    void leaveLoose(Place &place);
    bool query(const dxBounds &box, std::pmr::vector<Slot> &found);
    void buildIfDue(const dxMembers &members);
    void build(const dxMembers &members);
    void sortAlongCurve(const dxMembers &members);

    std::shared_mutex m_mutex;    // only try_lock is used: shared for a query, exclusive for a build
    bool m_isInUse = false;       // all members are in the tree or loose, from the first query on
    std::vector<Place> m_places;  // by slot
    std::vector<Slot> m_loose;
    dxBoxColumns m_looseBoxes;  // of m_loose
    std::vector<Slot> m_slotOfRow;
    dxBoxBvh m_tree;
    std::atomic<bool> m_isSelective{true}, m_isHighlySelective{true};
    std::atomic<std::size_t> m_debt{0};  // comparisons outside the tree since it was built
    std::vector<dxSortItem> m_items, m_spare;
};
