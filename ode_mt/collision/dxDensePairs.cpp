#include "collision/dxDensePairs.h"

#include <algorithm>

namespace {

auto standsBefore(const dxMembers &members) {
    return [&members](dxMembers::Slot a, dxMembers::Slot b) { return members[a].rank > members[b].rank; };
}

}  // namespace

void dxDensePairs::update(const dxMembers &members, std::vector<dxOrderedPair> &pairs) {
    gatherChanged(members);
    reorder(members);
    m_found.clear();
    if (changedAreInFront()) {
        findPairs(members, m_changed.size());
        for (const dxOrderedPair &pair : pairs)
            if (!members.isChanged(pair.slots[0]) && !members.isChanged(pair.slots[1])) m_found.push_back(pair);
    } else {
        // Filters of a geom further behind were set: it has not moved, and pairs with it come between others.
        findPairs(members, m_order.size());
    }
    pairs.swap(m_found);
}

void dxDensePairs::gatherChanged(const dxMembers &members) {
    m_changed.clear();
    for (const Slot slot : members.changed())
        if (members[slot].geom != nullptr) m_changed.push_back(slot);
    if (!std::is_sorted(m_changed.begin(), m_changed.end(), standsBefore(members)))
        std::sort(m_changed.begin(), m_changed.end(), standsBefore(members));
}

void dxDensePairs::reorder(const dxMembers &members) {
    const auto isBefore = standsBefore(members);
    m_nextOrder.clear();
    m_nextBoxes.clear();
    auto changed = m_changed.cbegin();
    const auto pushChanged = [&] {
        m_nextOrder.push_back(*changed);
        m_nextBoxes.push(members[*changed].bounds);
        ++changed;
    };
    for (std::size_t row = 0; row < m_order.size(); ++row) {
        const Slot slot = m_order[row];
        if (members.isChanged(slot)) continue;
        while (changed != m_changed.cend() && isBefore(*changed, slot)) pushChanged();
        m_nextOrder.push_back(slot);
        m_nextBoxes.pushRow(m_boxes, row);
    }
    while (changed != m_changed.cend()) pushChanged();
    m_order.swap(m_nextOrder);
    std::swap(m_boxes, m_nextBoxes);
}

bool dxDensePairs::changedAreInFront() const {
    return m_changed.empty() || m_order[m_changed.size() - 1] == m_changed.back();
}

void dxDensePairs::findPairs(const dxMembers &members, std::size_t rows) {
    m_rows.resize(m_order.size());
    for (std::size_t row = 0; row < rows; ++row) {
        const Slot slot = m_order[row];
        const dxMembers::Member &member = members[slot];
        const std::size_t count = dxOverlappingRows(m_boxes, member.bounds, row + 1, m_rows.data());
        for (std::size_t i = 0; i < count; ++i) {
            const Slot other = m_order[m_rows[i]];
            const dxMembers::Member &second = members[other];
            if (dxMayMeet(member.filter, second.filter)) m_found.push_back({member.geom, second.geom, {slot, other}});
        }
    }
}
