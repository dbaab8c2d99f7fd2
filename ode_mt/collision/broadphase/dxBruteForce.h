// Brute force for a small space: the changed boxes against all others, with SIMD.
//
// A call costs changed x all / vector length comparisons, so it suits spaces of some hundred geoms. There are two orders of rows: by slot, and by
// rank where pairs are ordered by rank.
#pragma once

#include <vector>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"

// A member's row is its slot, so a change writes one row and the boxes need no sort.
class dxBruteForceBroadphase final : public dxBroadphase {
public:
    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    // Takes over the members that have not changed, before the first findOverlaps().
    void adopt(const dxMembers &members);

private:
    using Slot = dxMembers::Slot;

    void findAllPairs(const dxMembers &members, std::vector<Match> &matches);
    void findPairsOfChanged(const dxMembers &members, std::vector<Match> &matches);

    dxBoxColumns m_boxes;              // by slot; removed members keep their last box
    std::vector<dxSlotPair> m_found;
    std::vector<std::uint32_t> m_rows;
};

// For spaces that pair each geom with those behind it, by ranks. In a simple space changed geoms are in front of all others, so the
// new pairs come first, in order as they are found, and the kept ones follow: no sort is needed. In a quad tree changed
// geoms mostly keep their places, and new pairs are merged with kept ones. The boxes are stored in the order of ranks.
class dxBruteForcePairs {
public:
    // Updates `pairs`, which are in order for the members before their changes. Returns the number of overlapping boxes that were found.
    std::size_t update(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

private:
    using Slot = dxMembers::Slot;

    void gatherChanged(const dxMembers &members);
    bool reorderFront(const dxMembers &members);
    void reorder(const dxMembers &members);
    void setBoxes(const dxMembers &members);
    bool changedAreInFront() const;
    std::size_t findPairs(const dxMembers &members, std::size_t rows);
    std::size_t findAround(const dxMembers &members);
    void push(const dxMembers &members, std::uint32_t row, std::uint32_t otherRow);

    std::vector<Slot> m_changed;             // front first
    std::vector<Slot> m_order, m_nextOrder;  // of all, front first
    std::vector<std::uint32_t> m_rowOf;      // by slot, in m_order; valid for those in it
    std::uint64_t m_orderings = 0;           // dxMembers::orderings() when they were put in order
    dxBoxColumns m_boxes, m_nextBoxes;       // of m_order
    std::vector<std::uint32_t> m_rows;
    std::vector<dxSlotPair> m_together;      // rows
    std::vector<std::uint64_t> m_around;     // pairs of rows, each packed in one number
    std::vector<dxOrderedPair> m_found, m_kept;
};
