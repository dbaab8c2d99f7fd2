#include "collision/pairs/dxMembers.h"

#include "core/dxReserve.h"

void dxMembers::reserveForOneMore() {
    const std::size_t slots = m_members.size() + 1;
    dxReserveCapacity(m_members, slots);
    dxReserveCapacity(m_geoms, slots);
    dxReserveCapacity(m_isChanged, slots);
    dxReserveCapacity(m_isSwitched, slots);
    dxReserveCapacity(m_arrivals, slots);
    dxReserveCapacity(m_free, slots);
    dxReserveCapacity(m_changed, slots);
    dxReserveCapacity(m_switched, slots);
}

dxMembers::Slot dxMembers::add(dxGeom *geom) {
    reserveForOneMore();
    Slot slot;
    if (m_free.empty()) {
        slot = end();
        m_members.emplace_back();
        m_geoms.push_back(nullptr);
        m_isChanged.push_back(0);
        m_isSwitched.push_back(0);
        m_arrivals.push_back(0);
    } else {
        slot = m_free.back();
        m_free.pop_back();
    }
    m_members[slot] = Member();
    m_members[slot].geom = m_geoms[slot] = geom;
    m_arrivals[slot] = ++m_lastArrival;
    ++m_unranked;
    ++m_orderings;
    markChanged(slot);
    return slot;
}

void dxMembers::remove(Slot slot) {
    Member &member = m_members[slot];
    if (member.rank == 0) --m_unranked;
    setPresence(slot, false);
    m_geoms[slot] = nullptr;
    m_free.push_back(slot);
}

void dxMembers::setPresence(Slot slot, bool isPresent) {
    dxGeom *const now = isPresent ? m_geoms[slot] : nullptr;
    if (m_members[slot].geom == now) return;
    m_members[slot].geom = now;
    ++m_orderings;
    note(slot, m_isChanged, m_changed);
}

void dxMembers::noteSwitch(Slot slot) { note(slot, m_isSwitched, m_switched); }

void dxMembers::forgetSwitches() { forget(m_isSwitched, m_switched); }

void dxMembers::forgetChanges() { forget(m_isChanged, m_changed); }
