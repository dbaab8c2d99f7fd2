// Pairs of a small simple space: the boxes that have changed against all others, by vectors.
//
// A simple space pairs each geom with those behind it in its list. What changed stands in front of all that
// did not, so the new pairs come first, in order as they are found, and the kept ones follow: nothing is
// sorted. The table of boxes is kept in the order of the list.
// A search costs changed x all / vector length comparisons, so it is for spaces of some hundred geoms.
#pragma once

#include <vector>

#include "collision/dxMembers.h"
#include "collision/dxOrderedPair.h"
#include "collision/overlap/dxBoxTable.h"

class dxDensePairs {
public:
    // Brings `pairs`, which are in order for the members before their changes, up to date.
    void update(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

private:
    using Slot = dxMembers::Slot;

    void gatherChanged(const dxMembers &members);
    void reorder(const dxMembers &members);
    bool changedAreInFront() const;
    void findPairs(const dxMembers &members, std::size_t rows);

    std::vector<Slot> m_changed;             // front first
    std::vector<Slot> m_order, m_nextOrder;  // of all, front first
    dxBoxTable m_boxes, m_nextBoxes;         // of m_order
    std::vector<std::uint32_t> m_rows;
    std::vector<dxOrderedPair> m_found;
};
