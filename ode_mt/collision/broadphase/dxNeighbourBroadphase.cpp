#include "collision/broadphase/dxNeighbourBroadphase.h"

void dxNeighbourBroadphase::adopt(const dxMembers &members) {
    m_isKnown.resize(members.end());
    for (dxMembers::Slot slot = 0; slot < members.end(); ++slot) {
        if (members[slot].geom == nullptr || members.isChanged(slot)) continue;
        m_neighbours.insert(slot, members[slot].bounds);
        m_isKnown[slot] = 1;
    }
}

void dxNeighbourBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner &, std::vector<Match> &matches) {
    updateNeighbours(members);
    for (const dxMembers::Slot slot : members.changed()) {
        if (members[slot].geom == nullptr) continue;
        for (const dxNeighbours::Candidate &candidate : m_neighbours.of(slot)) {
            const dxMembers::Slot other = candidate.slot;
            if (members.isChanged(other) && other < slot) continue;  // found from that side
            if (members[slot].bounds.overlaps(members[other].bounds)) matches.push_back({slot, other});
        }
    }
}

void dxNeighbourBroadphase::updateNeighbours(const dxMembers &members) {
    m_isKnown.resize(members.end());
    m_lookedUp = 0;
    for (const dxMembers::Slot slot : members.changed()) {
        if (members[slot].geom == nullptr) {
            if (m_isKnown[slot]) m_neighbours.remove(slot);
            m_isKnown[slot] = 0;
        } else if (m_isKnown[slot]) {
            m_lookedUp += m_neighbours.move(slot, members[slot].bounds);
        } else {
            m_neighbours.insert(slot, members[slot].bounds);
            m_isKnown[slot] = 1;
            ++m_lookedUp;
        }
    }
}
