// Pairs in order from call to call: those of which neither geom changed keep their places, and those found
// now are sorted by key and merged in.
#pragma once

#include <vector>

#include "collision/dxMembers.h"
#include "collision/dxOrderedPair.h"
#include "collision/dxPairKey.h"
#include "collision/dxPairSearch.h"

// The order of a kind of space.
class dxPairPlacer {
public:
    // The key of a pair whose boxes overlap, and in `swapped` whether b comes first in the callback. False:
    // upstream does not bring this pair.
    virtual bool place(dxMembers::Slot a, dxMembers::Slot b, dxPairKey &key, bool &swapped) const = 0;

protected:
    ~dxPairPlacer() = default;
};

class dxKeptPairs {
public:
    // Brings `pairs`, which are those of the last call, up to date. Matches of geoms that may not meet are
    // left out.
    void update(const dxMembers &members, const std::vector<dxPairSearch::Match> &matches,
                const dxPairPlacer &placer, std::vector<dxOrderedPair> &pairs);

private:
    struct Found {
        dxPairKey key;
        dxOrderedPair pair;

        friend bool operator<(const Found &a, const Found &b) { return a.key < b.key; }
    };

    void placeMatch(const dxPairSearch::Match &match, const dxMembers &members, const dxPairPlacer &placer);
    void merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

    std::vector<dxPairKey> m_keys, m_nextKeys;  // of the pairs
    std::vector<dxOrderedPair> m_nextPairs;
    std::vector<Found> m_found;
};
