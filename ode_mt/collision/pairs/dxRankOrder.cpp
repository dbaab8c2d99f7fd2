#include "collision/pairs/dxRankOrder.h"

#include <algorithm>
#include <iterator>

#include "core/dxReserve.h"

namespace {

// Fewer are sorted by comparisons.
constexpr std::size_t kMinRadixSorted = 64;

bool isBefore(const dxSortItem &a, const dxSortItem &b) { return a.key < b.key; }

}  // namespace

const std::vector<dxSortItem> &dxRankOrder::update(const dxMembers &members) {
    if (isCurrent(members)) return m_items;
    reserveMemory(members.end());
    gatherLoose(members);
    m_items.erase(std::remove_if(m_items.begin(), m_items.end(), [this](const dxSortItem &item) { return item.key != m_keys[item.index]; }),
                  m_items.end());
    if (m_loose.size() < kMinRadixSorted)
        std::sort(m_loose.begin(), m_loose.end(), isBefore);
    else
        dxRadixSort(m_loose, m_spare);
    m_spare.clear();
    std::merge(m_items.begin(), m_items.end(), m_loose.begin(), m_loose.end(), std::back_inserter(m_spare), isBefore);
    m_items.swap(m_spare);
    m_orderings = members.orderings();
    return m_items;
}

// Without memory nothing has changed.
void dxRankOrder::reserveMemory(std::size_t slots) {
    m_keys.resize(slots);
    for (std::vector<dxSortItem> *const items : {&m_items, &m_loose, &m_spare}) dxReserveCapacity(*items, slots);
}

// Finds the members that have no item, or one with another key.
void dxRankOrder::gatherLoose(const dxMembers &members) {
    m_loose.clear();
    for (dxMembers::Slot slot = 0; slot < members.end(); ++slot) {
        const std::uint64_t key = members.isPresent(slot) ? dxFrontFirst(members[slot].rank) : 0;
        if (key == m_keys[slot]) continue;
        m_keys[slot] = key;
        if (key != 0) m_loose.push_back({key, slot});
    }
}
