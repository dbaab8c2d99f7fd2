// The present members of a space in the order of their ranks, front first, kept from call to call: a call costs a look at each slot, and a sort of
// those that have another rank than at the last one. Threading: not thread-safe.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"
#include "core/dxRadixSort.h"

class dxRankOrder {
public:
    // Returns the members as they are now: their slots are the indices. Requires ranks that differ. Valid until the next call. Throws std::bad_alloc
    // without any change.
    const std::vector<dxSortItem> &update(const dxMembers &members);

    // Returns whether update() would change nothing: then several threads may call it.
    bool isCurrent(const dxMembers &members) const { return m_orderings == members.orderings(); }

private:
    void reserveMemory(std::size_t slots);
    void gatherLoose(const dxMembers &members);

    std::vector<dxSortItem> m_items, m_loose, m_spare;
    std::vector<std::uint64_t> m_keys;  // by slot: of the member's item; 0: it has none
    std::uint64_t m_orderings = 0;      // dxMembers::orderings() when they were put in order
};
