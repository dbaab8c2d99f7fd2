// A way of finding the pairs of members whose boxes overlap.
#pragma once

#include <vector>

#include "collision/dxMembers.h"
#include "collision/dxSlotPair.h"
#include "threading/dxTaskRunner.h"

class dxPairSearch {
public:
    using Match = dxSlotPair;

    virtual ~dxPairSearch() = default;

    // Appends every pair with overlapping boxes of which at least one member has changed, each pair once, in
    // any order. Called whenever members have changed; at the first call all have. May share the work out.
    virtual void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) = 0;
};
