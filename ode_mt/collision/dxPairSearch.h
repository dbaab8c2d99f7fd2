// A way of finding the pairs of members whose boxes overlap.
#pragma once

#include <vector>

#include "collision/dxMembers.h"

class dxPairSearch {
public:
    struct Match {
        dxMembers::Slot a, b;
    };

    virtual ~dxPairSearch() = default;

    // Appends every pair with overlapping boxes of which at least one member has changed, each pair once, in
    // any order. Called whenever members have changed; at the first call all have.
    virtual void search(const dxMembers &members, std::vector<Match> &matches) = 0;
};
