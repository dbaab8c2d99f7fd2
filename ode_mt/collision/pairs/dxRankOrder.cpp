#include "collision/pairs/dxRankOrder.h"

#include <algorithm>
#include <iterator>

#include "core/dxReserve.h"

namespace {

// Members below which a sort by comparisons is faster.
constexpr std::size_t kMinRadixSorted = 64;

bool isBefore(const dxSortItem &a, const dxSortItem &b) { return a.key < b.key; }

}  // namespace

const std::vector<dxSortItem> &dxRankOrder::update(const dxMembers &members) {
    if (isCurrent(members)) return m_items;
    reserveMemory(members.end());
    gatherUnplaced(members);
    m_items.erase(std::remove_if(m_items.begin(), m_items.end(), [this](const dxSortItem &item) { return item.key != m_keys[item.index]; }),
                  m_items.end());
    if (m_unplaced.size() < kMinRadixSorted)
        std::sort(m_unplaced.begin(), m_unplaced.end(), isBefore);
    else
        dxRadixSort(m_unplaced, m_spare);
    m_spare.clear();
    std::merge(m_items.begin(), m_items.end(), m_unplaced.begin(), m_unplaced.end(), std::back_inserter(m_spare), isBefore);
    m_items.swap(m_spare);
    m_orderings = members.orderings();
    return m_items;
}

// Allocates first, so that without memory nothing has changed.
void dxRankOrder::reserveMemory(std::size_t slots) {
    m_keys.resize(slots);
    for (std::vector<dxSortItem> *const items : {&m_items, &m_unplaced, &m_spare}) dxReserveCapacity(*items, slots);
}

// Finds the members that have no item, or whose item has another key.
void dxRankOrder::gatherUnplaced(const dxMembers &members) {
    m_unplaced.clear();
    for (dxMembers::Slot slot = 0; slot < members.end(); ++slot) {
        const std::uint64_t key = members.isPresent(slot) ? dxFrontFirst(members[slot].rank) : 0;
        if (key == m_keys[slot]) continue;
        m_keys[slot] = key;
        if (key != 0) m_unplaced.push_back({key, slot});
    }
}
