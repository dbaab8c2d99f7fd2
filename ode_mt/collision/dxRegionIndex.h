// Which members of a space overlap a given box: for rays, sensors, and whatever else is tested against a whole space.
//
// Members that rest are in a tree (overlap/dxBoxTree.h). One that changes becomes loose, and is compared with every
// box asked for. Comparing loose members costs time with each question, building the tree costs it once: the tree is
// built anew when the comparisons made since have cost as much. So a space that is never asked builds none,
// and in one that is asked often, whether or not things move in it, a question costs a logarithm.
//
// Not thread safe.
#pragma once

#include <vector>

#include "collision/dxMembers.h"
#include "collision/dxRadixSort.h"
#include "collision/overlap/dxBoxTree.h"

class dxRegionIndex {
public:
    using Slot = dxMembers::Slot;

    // All members are loose.
    explicit dxRegionIndex(const dxMembers &members);

    // The member is new or has changed.
    void loosen(Slot slot);
    // The member has gone.
    void drop(Slot slot);

    // Fills `found` with the members whose boxes overlap `box`, the one furthest to the front of the list first.
    void find(const dxMembers &members, const dxBounds &box, std::vector<Slot> &found);

private:
    static constexpr std::uint32_t kNone = UINT32_MAX;

    struct Home {
        std::uint32_t row = kNone;    // in the tree
        std::uint32_t loose = kNone;  // place in m_loose
    };

    Home &homeOf(Slot slot);
    void leaveLoose(Home &home);
    void build(const dxMembers &members);
    void sortAlongCurve(const dxMembers &members);

    std::vector<Home> m_homes;  // by slot
    std::vector<Slot> m_loose;
    std::vector<Slot> m_slotOfRow;
    dxBoxTree m_tree;
    std::size_t m_debt = 0;  // comparisons with loose members since the tree was built
    std::vector<std::uint32_t> m_rows;
    std::vector<dxSortItem> m_items, m_spare;
};
