// Members of a space without a space: boxes that come, go and change, and the pairs that a search has to find.
#pragma once

#include <set>
#include <utility>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/pairs/dxMembers.h"

class BroadphaseMembers {
public:
    using Slot = dxMembers::Slot;
    using Pairs = std::multiset<std::pair<Slot, Slot>>;  // the lower slot first

    Slot add(const dxBounds &box);
    void move(Slot slot, const dxBounds &box);
    void remove(Slot slot) { m_members.remove(slot); }

    const dxMembers &members() const { return m_members; }
    bool isThere(Slot slot) const { return slot < m_members.end() && m_members[slot].geom != nullptr; }

    // Returns the pairs of which one member has changed, by brute force.
    Pairs expected() const;
    // Returns the pairs that the broad phase finds, and forgets the changes.
    Pairs found(dxBroadphase &broadphase, dxTaskRunner &runner = dxTaskRunner::alone());

private:
    dxMembers m_members;
};
