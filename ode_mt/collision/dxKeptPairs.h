// Pairs in order from call to call: those of which neither geom changed keep their places, and those found
// now are sorted by key and merged in.
#pragma once

#include <vector>

#include "collision/dxMembers.h"
#include "collision/dxOrderedPair.h"
#include "collision/dxPairKey.h"
#include "collision/dxPairSearch.h"
#include "collision/dxRadixSort.h"

// The order of a kind of space.
class dxPairPlacer {
public:
    // The key of a pair whose boxes overlap, and in `swapped` whether b comes first in the callback. False:
    // upstream does not bring this pair.
    virtual bool place(dxMembers::Slot a, dxMembers::Slot b, dxPairKey &key, bool &swapped) const = 0;

    // The pair is about to be placed: its members may be fetched from memory.
    virtual void expect(dxMembers::Slot a, dxMembers::Slot b) const = 0;

protected:
    ~dxPairPlacer() = default;
};

class dxKeptPairs {
public:
    // Brings `pairs`, which are those of the last call, up to date. Matches of geoms that may not meet are
    // left out.
    void update(const dxMembers &members, const std::vector<dxPairSearch::Match> &matches,
                const dxPairPlacer &placer, dxTaskRunner &runner, std::vector<dxOrderedPair> &pairs);

private:
    struct Found {
        dxPairKey key;
        dxOrderedPair pair;
    };

    void placeAll(const dxMembers &members, const std::vector<dxPairSearch::Match> &matches,
                  const dxPairPlacer &placer, dxTaskRunner &runner);
    void sortFound(dxTaskRunner &runner);
    void sortRuns(std::size_t begin, std::size_t end);
    void insertSorted(std::size_t begin, std::size_t last, const Found &found);
    void merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

    std::vector<dxPairKey> m_keys, m_nextKeys;  // of the pairs
    std::vector<dxOrderedPair> m_nextPairs;
    std::vector<Found> m_found;                // by match
    std::vector<std::uint8_t> m_isPlaced;      // by match
    std::vector<dxPairKey> m_keptKeys;
    std::vector<dxOrderedPair> m_keptPairs;
    std::vector<dxSortItem> m_items, m_spare;  // by a key's first word
};
