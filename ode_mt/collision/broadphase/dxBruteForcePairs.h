// Brute force for a small space whose pairs are ordered by rank: the changed boxes against all others, with SIMD.
//
// Such a space pairs each geom with those behind it. In a simple space changed geoms are in front of all others, so the
// new pairs come first, in order as they are found, and the kept ones follow: no sort is needed. In a quad tree changed
// geoms mostly keep their places, and new pairs are merged with kept ones. The boxes are stored in the order of ranks.
// An update costs changed x all / vector length comparisons, so the class is for spaces of some hundred geoms.
#pragma once

#include <vector>

#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"

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
    void keepUnchanged(const dxMembers &members, const std::vector<dxOrderedPair> &pairs,
                       std::vector<dxOrderedPair> &kept) const;

    std::vector<Slot> m_changed;             // front first
    std::vector<Slot> m_order, m_nextOrder;  // of all, front first
    std::vector<std::uint32_t> m_rowOf;      // by slot, in m_order; valid for those in it
    std::uint64_t m_orderings = 0;           // dxMembers::orderings() when they were put in order
    dxBoxColumns m_boxes, m_nextBoxes;         // of m_order
    std::vector<std::uint32_t> m_rows;
    std::vector<dxSlotPair> m_together;      // rows
    std::vector<std::uint64_t> m_around;     // pairs of rows, each packed in one number
    std::vector<dxOrderedPair> m_found, m_kept;
};
