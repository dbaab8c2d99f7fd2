#include "BroadphaseMembers.h"

#include <algorithm>
#include <vector>

namespace {

// A search only asks whether there is one.
dxGeom *someGeom() {
    static char storage;
    return reinterpret_cast<dxGeom *>(&storage);
}

}  // namespace

BroadphaseMembers::Slot BroadphaseMembers::add(const dxBounds &box) {
    const Slot slot = m_members.add(someGeom());
    move(slot, box);
    return slot;
}

void BroadphaseMembers::move(Slot slot, const dxBounds &box) {
    m_members.setRank(slot, m_members.firstOf(1));
    m_members.setBounds(slot, box);
    m_members.markChanged(slot);
}

BroadphaseMembers::Pairs BroadphaseMembers::expected() const {
    Pairs pairs;
    for (Slot a = 0; a < m_members.end(); ++a)
        for (Slot b = a + 1; b < m_members.end(); ++b)
            if (isThere(a) && isThere(b) && (m_members.isChanged(a) || m_members.isChanged(b)) &&
                m_members[a].bounds.overlaps(m_members[b].bounds))
                pairs.insert({a, b});
    return pairs;
}

BroadphaseMembers::Pairs BroadphaseMembers::found(dxBroadphase &broadphase, dxTaskRunner &runner) {
    std::vector<dxBroadphase::Match> matches;
    broadphase.findOverlaps(m_members, runner, matches);
    m_members.forgetChanges();
    Pairs pairs;
    for (const dxBroadphase::Match &match : matches)
        pairs.insert({std::min(match.a, match.b), std::max(match.a, match.b)});
    return pairs;
}
