// Pairs of any space, found among neighbours: what changed since the last time costs, the rest is kept.
//
// The pairs of which neither geom changed keep their order; those found now are sorted by key and merged in.
#pragma once

#include <vector>

#include "collision/dxMembers.h"
#include "collision/dxNeighbours.h"
#include "collision/dxOrderedPair.h"
#include "collision/dxPairKey.h"

// The order of a kind of space.
class dxPairPlacer {
public:
    // The key of a pair whose boxes overlap, and in `swapped` whether b comes first in the callback. False:
    // upstream does not bring this pair.
    virtual bool place(dxMembers::Slot a, dxMembers::Slot b, dxPairKey &key, bool &swapped) const = 0;

protected:
    ~dxPairPlacer() = default;
};

class dxSparsePairs {
public:
    // Brings `pairs`, which are those of the last call, up to date.
    void update(const dxMembers &members, const dxPairPlacer &placer, std::vector<dxOrderedPair> &pairs);

private:
    using Slot = dxMembers::Slot;

    struct Found {
        dxPairKey key;
        dxOrderedPair pair;

        friend bool operator<(const Found &a, const Found &b) { return a.key < b.key; }
    };

    void updateNeighbours(const dxMembers &members);
    void findPairs(Slot slot, const dxMembers &members, const dxPairPlacer &placer);
    void merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

    dxNeighbours m_neighbours;
    std::vector<std::uint8_t> m_isKnown;  // by slot: is in m_neighbours
    std::vector<dxPairKey> m_keys, m_nextKeys;  // of the pairs
    std::vector<dxOrderedPair> m_nextPairs;
    std::vector<Found> m_found;
};
