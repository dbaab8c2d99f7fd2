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

    // The group of members that belong to none.
    static constexpr int kNoGroup = -1;
    // Returns, after findOverlaps(), the group of a member, for callbacks on several threads; one worker delivers the pairs of a group. Groups are
    // numbered from 0. A broad phase that does not group members (by clusters) returns kNoGroup.
    virtual int groupOf(dxMembers::Slot) const { return kNoGroup; }
    // Returns, after findOverlaps(), the number of threads that the callbacks should use, from 1 to the limit.
    virtual unsigned threads(unsigned limit) const { return limit; }
};
