// Pairs of a small space whose pairs come by rank: the boxes that have changed against all others, by vectors.
//
// Such a space pairs each geom with those behind it. In a simple space what changed stands in front of all that
// did not, so the new pairs come first, in order as they are found, and the kept ones follow: nothing is
// sorted. In a quad tree what changed mostly stays where it stood, and new pairs come between kept ones. The table of
// boxes is kept in the order of ranks.
// A search costs changed x all / vector length comparisons, so it is for spaces of some hundred geoms.
#pragma once

#include <vector>

#include "collision/broadphase/overlap/dxBoxTable.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxOrderedPair.h"

class dxDensePairs {
public:
    // Brings `pairs`, which are in order for the members before their changes, up to date.
    void update(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

private:
    using Slot = dxMembers::Slot;

    void gatherChanged(const dxMembers &members);
    bool reorderFront(const dxMembers &members);
    void reorder(const dxMembers &members);
    void setBoxes(const dxMembers &members);
    bool changedAreInFront() const;
    void findPairs(const dxMembers &members, std::size_t rows);
    void findAround(const dxMembers &members);
    void push(const dxMembers &members, std::uint32_t row, std::uint32_t otherRow);
    void keepUnchanged(const dxMembers &members, const std::vector<dxOrderedPair> &pairs,
                       std::vector<dxOrderedPair> &kept) const;

    std::vector<Slot> m_changed;             // front first
    std::vector<Slot> m_order, m_nextOrder;  // of all, front first
    std::vector<std::uint32_t> m_rowOf;      // by slot, in m_order; right for those that are there
    std::uint64_t m_orderings = 0;           // of the members, when they were put in order
    dxBoxTable m_boxes, m_nextBoxes;         // of m_order
    std::vector<std::uint32_t> m_rows;
    std::vector<dxSlotPair> m_together;      // rows
    std::vector<std::uint64_t> m_around;     // pairs of rows, in one number each
    std::vector<dxOrderedPair> m_found, m_kept;
};
