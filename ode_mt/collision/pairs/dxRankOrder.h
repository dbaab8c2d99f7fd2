// The present members of a space in the order of their ranks, front first, kept from call to call. A call visits each slot, and sorts the members
// whose rank has changed since the last call. Threading: not thread-safe.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"
#include "core/dxRadixSort.h"

class dxRankOrder {
public:
    // Returns an item for each present member, with its slot as index. Requires that all ranks differ. Valid until the next call. Throws
    // std::bad_alloc without any change.
    const std::vector<dxSortItem> &update(const dxMembers &members);

    // Returns whether update() would change nothing: then several threads may call it.
    bool isCurrent(const dxMembers &members) const { return m_orderings == members.orderings(); }

private:
    void reserveMemory(std::size_t slots);
    void gatherUnplaced(const dxMembers &members);

    std::vector<dxSortItem> m_items, m_unplaced, m_spare;
    std::vector<std::uint64_t> m_keys;  // by slot: key of the member's item; 0: it has no item
    std::uint64_t m_orderings = 0;      // dxMembers::orderings() at the last update
};
