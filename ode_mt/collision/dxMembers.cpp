#include "collision/dxMembers.h"

dxMembers::Slot dxMembers::add(dxGeom *geom) {
    Slot slot;
    if (m_free.empty()) {
        slot = end();
        m_members.emplace_back();
        m_isChanged.push_back(0);
    } else {
        slot = m_free.back();
        m_free.pop_back();
    }
    m_members[slot] = Member();
    m_members[slot].geom = geom;
    ++m_unranked;
    ++m_orderings;
    markChanged(slot);
    return slot;
}

void dxMembers::remove(Slot slot) {
    Member &member = m_members[slot];
    if (member.rank == 0) --m_unranked;
    if (member.sought) {
        markChanged(slot);
        m_gone.push_back(slot);
    } else {
        m_free.push_back(slot);
    }
    member.geom = nullptr;
    ++m_orderings;
}

void dxMembers::forgetChanges() {
    for (const Slot slot : m_changed) m_isChanged[slot] = 0;
    m_changed.clear();
    m_free.insert(m_free.end(), m_gone.begin(), m_gone.end());
    m_gone.clear();
}
