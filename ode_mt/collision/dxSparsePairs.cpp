#include "collision/dxSparsePairs.h"

#include <algorithm>

void dxSparsePairs::update(const dxMembers &members, const dxPairPlacer &placer,
                           std::vector<dxOrderedPair> &pairs) {
    updateNeighbours(members);
    m_found.clear();
    for (const Slot slot : members.changed())
        if (members[slot].geom != nullptr) findPairs(slot, members, placer);
    std::sort(m_found.begin(), m_found.end());
    merge(members, pairs);
}

void dxSparsePairs::updateNeighbours(const dxMembers &members) {
    m_isKnown.resize(members.end());
    for (const Slot slot : members.changed()) {
        if (members[slot].geom == nullptr) {
            if (m_isKnown[slot]) m_neighbours.remove(slot);
            m_isKnown[slot] = 0;
        } else if (m_isKnown[slot]) {
            m_neighbours.move(slot, members[slot].bounds);
        } else {
            m_neighbours.insert(slot, members[slot].bounds);
            m_isKnown[slot] = 1;
        }
    }
}

void dxSparsePairs::findPairs(Slot slot, const dxMembers &members, const dxPairPlacer &placer) {
    const dxMembers::Member &member = members[slot];
    for (const dxNeighbours::Candidate &candidate : m_neighbours.of(slot)) {
        const Slot otherSlot = candidate.slot;
        if (members.isChanged(otherSlot) && otherSlot < slot) continue;  // found from that side
        const dxMembers::Member &other = members[otherSlot];
        if (!member.bounds.overlaps(other.bounds) || !dxMayMeet(member.geom, other.geom)) continue;
        dxPairKey key;
        bool swapped = false;
        if (!placer.place(slot, otherSlot, key, swapped)) continue;
        if (swapped)
            m_found.push_back({key, {other.geom, member.geom, {otherSlot, slot}}});
        else
            m_found.push_back({key, {member.geom, other.geom, {slot, otherSlot}}});
    }
}

void dxSparsePairs::merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs) {
    m_nextKeys.clear();
    m_nextPairs.clear();
    const auto push = [&](const dxPairKey &key, const dxOrderedPair &pair) {
        m_nextKeys.push_back(key);
        m_nextPairs.push_back(pair);
    };
    auto found = m_found.cbegin();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (members.isChanged(pairs[i].slots[0]) || members.isChanged(pairs[i].slots[1])) continue;
        for (; found != m_found.cend() && found->key < m_keys[i]; ++found) push(found->key, found->pair);
        push(m_keys[i], pairs[i]);
    }
    for (; found != m_found.cend(); ++found) push(found->key, found->pair);
    m_keys.swap(m_nextKeys);
    pairs.swap(m_nextPairs);
}
