#include "collision/broadphase/dxBruteForce.h"

#include <algorithm>

#include "collision/broadphase/dxBroadphaseChoice.h"

namespace {

bool arePresent(const dxMembers &members, const dxSlotPair &pair) {
    return members.isPresent(pair.a) && members.isPresent(pair.b);
}

auto isInFrontOf(const dxMembers &members) {
    return [&members](dxMembers::Slot a, dxMembers::Slot b) { return members[a].rank > members[b].rank; };
}

auto precedes(const dxMembers &members) {
    return [&members](const dxOrderedPair &a, const dxOrderedPair &b) {
        const dxRank rankA = members[a.slots[0]].rank, rankB = members[b.slots[0]].rank;
        return rankA != rankB ? rankA > rankB : members[a.slots[1]].rank > members[b.slots[1]].rank;
    };
}

void keepUnchanged(const dxMembers &members, const std::vector<dxOrderedPair> &pairs, std::vector<dxOrderedPair> &kept) {
    for (const dxOrderedPair &pair : pairs)
        if (members.areUnchanged(pair.slots[0], pair.slots[1])) kept.push_back(pair);
}

}  // namespace

void dxBruteForceBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner & /*runner*/, std::vector<Match> &matches) {
    while (m_boxes.size() < members.end()) m_boxes.push(members[static_cast<Slot>(m_boxes.size())].bounds);
    for (const Slot slot : members.changed()) m_boxes.set(slot, members[slot].bounds);
    if (dxHaveMostChanged(members.changed().size(), members.end()))
        findAllPairs(members, matches);
    else
        findPairsOfChanged(members, matches);
}

void dxBruteForceBroadphase::adopt(const dxMembers &members) {
    m_boxes.clear();
    for (Slot slot = 0; slot < members.end(); ++slot) m_boxes.push(members[slot].bounds);
}

// Finds each pair once, and leaves out those of which no member has changed.
void dxBruteForceBroadphase::findAllPairs(const dxMembers &members, std::vector<Match> &matches) {
    const std::size_t count = dxOverlappingPairs(m_boxes, m_boxes.size(), m_found);
    for (std::size_t i = 0; i < count; ++i) {
        const dxSlotPair &pair = m_found[i];
        if (!members.areUnchanged(pair.a, pair.b) && arePresent(members, pair)) matches.push_back(pair);
    }
}

// A pair of two changed members is found from both; it is taken from the lower slot.
void dxBruteForceBroadphase::findPairsOfChanged(const dxMembers &members, std::vector<Match> &matches) {
    m_rows.resize(m_boxes.size());
    for (const Slot slot : members.changed()) {
        if (!members.isPresent(slot)) continue;
        const std::size_t count = dxOverlappingRows(m_boxes, members[slot].bounds, 0, m_boxes.size(), m_rows.data());
        for (std::size_t i = 0; i < count; ++i) {
            const Slot other = m_rows[i];
            const bool isFoundFromOther = members.isChanged(other) && other <= slot;
            if (!isFoundFromOther && arePresent(members, {slot, other})) matches.push_back({slot, other});
        }
    }
}

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
        std::merge(m_found.begin(), m_found.end(), m_kept.begin(), m_kept.end(), pairs.begin(), precedes(members));
    }
    return overlaps;
}

void dxBruteForcePairs::gatherChanged(const dxMembers &members) {
    m_changed.clear();
    for (const Slot slot : members.changed())
        if (members.isPresent(slot)) m_changed.push_back(slot);
    if (!std::is_sorted(m_changed.begin(), m_changed.end(), isInFrontOf(members)))
        std::sort(m_changed.begin(), m_changed.end(), isInFrontOf(members));
}

// Reorders only the front, where the members that have changed are those that were in front, as robots are among objects at rest. Returns false if
// they are not.
bool dxBruteForcePairs::reorderFront(const dxMembers &members) {
    const std::size_t count = m_changed.size();
    const auto wasInFront = [&](Slot slot) {
        return slot < m_rowOf.size() && m_rowOf[slot] < count && m_order[m_rowOf[slot]] == slot;
    };
    const bool isAnyRemoved = members.changed().size() != count;
    if (isAnyRemoved || count == 0 || count > m_order.size()) return false;
    if (!std::all_of(m_changed.begin(), m_changed.end(), wasInFront)) return false;
    if (count < m_order.size() && !isInFrontOf(members)(m_changed.back(), m_order[count])) return false;
    for (std::uint32_t row = 0; row < count; ++row) {
        m_order[row] = m_changed[row];
        m_rowOf[m_changed[row]] = row;
    }
    setBoxes(members);
    return true;
}

void dxBruteForcePairs::reorder(const dxMembers &members) {
    const auto isBefore = isInFrontOf(members);
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

// Leaves out slots without a member: they have no row.
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
            const bool isFoundFromOther = other <= row && members.isChanged(m_order[other]);
            if (!isFoundFromOther)
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
