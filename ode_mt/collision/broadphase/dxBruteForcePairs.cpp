#include "collision/broadphase/dxBruteForcePairs.h"

#include <algorithm>

#include "collision/broadphase/dxBroadphaseChoice.h"

namespace {

auto standsBefore(const dxMembers &members) {
    return [&members](dxMembers::Slot a, dxMembers::Slot b) { return members[a].rank > members[b].rank; };
}

auto comesBefore(const dxMembers &members) {
    return [&members](const dxOrderedPair &a, const dxOrderedPair &b) {
        const dxRank rankA = members[a.slots[0]].rank, rankB = members[b.slots[0]].rank;
        return rankA != rankB ? rankA > rankB : members[a.slots[1]].rank > members[b.slots[1]].rank;
    };
}

}  // namespace

std::size_t dxBruteForcePairs::update(const dxMembers &members, std::vector<dxOrderedPair> &pairs) {
    const bool stayInPlace = m_orderings == members.orderings();
    if (stayInPlace) {
        setBoxes(members);
    } else {
        gatherChanged(members);
        if (!reorderFront(members)) reorder(members);
        m_orderings = members.orderings();
    }
    m_found.clear();
    std::size_t overlaps;
    if (!stayInPlace && changedAreInFront()) {
        overlaps = findPairs(members, m_changed.size());
        keepUnchanged(members, pairs, m_found);
        pairs.swap(m_found);
    } else if (dxHaveMostChanged(members.changed().size(), m_order.size())) {
        overlaps = findPairs(members, m_order.size());
        pairs.swap(m_found);
    } else {
        m_kept.clear();
        keepUnchanged(members, pairs, m_kept);
        overlaps = findAround(members);
        pairs.resize(m_found.size() + m_kept.size());
        std::merge(m_found.begin(), m_found.end(), m_kept.begin(), m_kept.end(), pairs.begin(), comesBefore(members));
    }
    return overlaps;
}

void dxBruteForcePairs::keepUnchanged(const dxMembers &members, const std::vector<dxOrderedPair> &pairs,
                                 std::vector<dxOrderedPair> &kept) const {
    for (const dxOrderedPair &pair : pairs)
        if (!members.isChanged(pair.slots[0]) && !members.isChanged(pair.slots[1])) kept.push_back(pair);
}

void dxBruteForcePairs::gatherChanged(const dxMembers &members) {
    m_changed.clear();
    for (const Slot slot : members.changed())
        if (members[slot].geom != nullptr) m_changed.push_back(slot);
    if (!std::is_sorted(m_changed.begin(), m_changed.end(), standsBefore(members)))
        std::sort(m_changed.begin(), m_changed.end(), standsBefore(members));
}

// Where those that have changed are those that stood in front, as robots do among things that rest, nothing else moves.
bool dxBruteForcePairs::reorderFront(const dxMembers &members) {
    const std::size_t count = m_changed.size();
    const auto stoodInFront = [&](Slot slot) {
        return slot < m_rowOf.size() && m_rowOf[slot] < count && m_order[m_rowOf[slot]] == slot;
    };
    const bool hasAnyGone = members.changed().size() != count;
    if (hasAnyGone || count == 0 || count > m_order.size()) return false;
    if (!std::all_of(m_changed.begin(), m_changed.end(), stoodInFront)) return false;
    if (count < m_order.size() && !standsBefore(members)(m_changed.back(), m_order[count])) return false;
    for (std::uint32_t row = 0; row < count; ++row) {
        m_order[row] = m_changed[row];
        m_rowOf[m_changed[row]] = row;
    }
    setBoxes(members);
    return true;
}

void dxBruteForcePairs::reorder(const dxMembers &members) {
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
        m_nextBoxes.push(m_boxes.row(row));
    }
    while (changed != m_changed.cend()) pushChanged();
    m_order.swap(m_nextOrder);
    m_rowOf.resize(members.end());
    for (std::uint32_t row = 0; row < m_order.size(); ++row) m_rowOf[m_order[row]] = row;
    std::swap(m_boxes, m_nextBoxes);
}

// Slots without a member have no row.
void dxBruteForcePairs::setBoxes(const dxMembers &members) {
    for (const Slot slot : members.changed())
        if (members.isPresent(slot)) m_boxes.set(m_rowOf[slot], members[slot].bounds);
}

bool dxBruteForcePairs::changedAreInFront() const {
    return m_changed.empty() || m_order[m_changed.size() - 1] == m_changed.back();
}

std::size_t dxBruteForcePairs::findPairs(const dxMembers &members, std::size_t rows) {
    const std::size_t count = dxOverlappingPairs(m_boxes, rows, m_together);
    for (std::size_t i = 0; i < count; ++i) push(members, m_together[i].a, m_together[i].b);
    return count;
}

// Finds the pairs of changed members, at any places, with all others.
std::size_t dxBruteForcePairs::findAround(const dxMembers &members) {
    m_rows.resize(m_order.size());
    m_around.clear();
    for (std::uint32_t row = 0; row < m_order.size(); ++row) {
        if (!members.isChanged(m_order[row])) continue;
        const std::size_t count = dxOverlappingRows(m_boxes, members[m_order[row]].bounds, 0, m_boxes.size(), m_rows.data());
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t other = m_rows[i];
            const bool isFoundFromThere = other <= row && members.isChanged(m_order[other]);
            if (!isFoundFromThere)
                m_around.push_back(static_cast<std::uint64_t>(std::min(row, other)) << 32 | std::max(row, other));
        }
    }
    std::sort(m_around.begin(), m_around.end());
    for (const std::uint64_t rows : m_around)
        push(members, static_cast<std::uint32_t>(rows >> 32), static_cast<std::uint32_t>(rows));
    return m_around.size();
}

void dxBruteForcePairs::push(const dxMembers &members, std::uint32_t row, std::uint32_t otherRow) {
    const Slot slot = m_order[row], other = m_order[otherRow];
    const dxMembers::Member &first = members[slot], &second = members[other];
    if (dxFiltersAgree(first.filter, second.filter)) m_found.push_back({first.geom, second.geom, {slot, other}});
}
