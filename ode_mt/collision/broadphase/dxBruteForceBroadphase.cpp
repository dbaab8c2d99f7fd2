#include "collision/broadphase/dxBruteForceBroadphase.h"

#include "collision/broadphase/dxBroadphaseChoice.h"

namespace {

bool areThere(const dxMembers &members, const dxSlotPair &pair) {
    return members[pair.a].geom != nullptr && members[pair.b].geom != nullptr;
}

}  // namespace

void dxBruteForceBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner & /*runner*/, std::vector<Match> &matches) {
    while (m_boxes.size() < members.end()) m_boxes.push(members[static_cast<Slot>(m_boxes.size())].bounds);
    for (const Slot slot : members.changed()) m_boxes.set(slot, members[slot].bounds);
    if (dxHaveMostChanged(members.changed().size(), members.end()))
        searchAll(members, matches);
    else
        findPairsOfChanged(members, matches);
}

void dxBruteForceBroadphase::adopt(const dxMembers &members) {
    m_boxes.clear();
    for (Slot slot = 0; slot < members.end(); ++slot) m_boxes.push(members[slot].bounds);
}

// Each pair once, of which some may not have changed.
void dxBruteForceBroadphase::searchAll(const dxMembers &members, std::vector<Match> &matches) {
    const std::size_t count = dxOverlappingPairs(m_boxes, m_boxes.size(), m_found);
    for (std::size_t i = 0; i < count; ++i) {
        const dxSlotPair &pair = m_found[i];
        const bool isNew = members.isChanged(pair.a) || members.isChanged(pair.b);
        if (isNew && areThere(members, pair)) matches.push_back(pair);
    }
}

// Pairs of two that have changed are found from either: that of the lower slot counts.
void dxBruteForceBroadphase::findPairsOfChanged(const dxMembers &members, std::vector<Match> &matches) {
    m_rows.resize(m_boxes.size());
    for (const Slot slot : members.changed()) {
        if (members[slot].geom == nullptr) continue;
        const std::size_t count = dxOverlappingRows(m_boxes, members[slot].bounds, 0, m_boxes.size(), m_rows.data());
        for (std::size_t i = 0; i < count; ++i) {
            const Slot other = m_rows[i];
            const bool isFoundFromThere = members.isChanged(other) && other <= slot;
            if (!isFoundFromThere && areThere(members, {slot, other})) matches.push_back({slot, other});
        }
    }
}
