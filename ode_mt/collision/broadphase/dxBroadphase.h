// A broad phase: finds the pairs of members whose boxes overlap.
#pragma once

#include <vector>

#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"
#include "threading/dxTaskRunner.h"

class dxBroadphase {
public:
    using Match = dxSlotPair;

    virtual ~dxBroadphase() = default;

    // Appends every pair with overlapping boxes of which at least one member has changed, each pair once, in any order.
    // Called whenever members have changed; at the first call all have. It may run chunks on the runner's workers.
    virtual void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) = 0;

    // What a search that groups members (by clusters) has to say of callbacks on several threads. Of the last search.
    static constexpr int kNoGroup = -1;
    // Returns the group of a member, whose pairs one worker delivers; groups are numbered from 0.
    virtual int groupOf(dxMembers::Slot) const { return kNoGroup; }
    // Returns how many threads the callbacks should use, from 1 to the limit.
    virtual unsigned threads(unsigned limit) const { return limit; }
};
