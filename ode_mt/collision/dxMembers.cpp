#include "collision/dxMembers.h"

#include "collision/dxRoom.h"

void dxMembers::makeRoomForOne() {
    const std::size_t slots = m_members.size() + 1;
    dxMakeRoom(m_members, slots);
    dxMakeRoom(m_isChanged, slots);
    dxMakeRoom(m_arrivals, slots);
    dxMakeRoom(m_free, slots);
    dxMakeRoom(m_changed, slots);
}

dxMembers::Slot dxMembers::add(dxGeom *geom) {
    makeRoomForOne();
    Slot slot;
    if (m_free.empty()) {
        slot = end();
        m_members.emplace_back();
        m_isChanged.push_back(0);
        m_arrivals.push_back(0);
    } else {
        slot = m_free.back();
        m_free.pop_back();
    }
    m_members[slot] = Member();
    m_members[slot].geom = geom;
    m_arrivals[slot] = ++m_lastArrival;
    ++m_unranked;
    ++m_orderings;
    markChanged(slot);
    return slot;
}

void dxMembers::remove(Slot slot) {
    Member &member = m_members[slot];
    if (member.rank == 0) --m_unranked;
    member.geom = nullptr;
    markChanged(slot);
    m_free.push_back(slot);
    ++m_orderings;
}

void dxMembers::forgetChanges() {
    for (const Slot slot : m_changed) m_isChanged[slot] = 0;
    m_changed.clear();
}
