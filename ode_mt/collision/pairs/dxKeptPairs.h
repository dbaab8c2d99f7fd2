// Pairs in order from call to call: those of which neither geom changed keep their places, and those found
// now are sorted by key and merged in.
//
// A pair's key is made in two steps. Its first word tells who brings the pair, and is all that most of the sorting
// needs. The rest puts the few pairs of one geom in order: it is made when these stand together, one member of all
// of them in the cache, and goes straight to where it stays.
#pragma once

#include <vector>

#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxOrderedPair.h"
#include "collision/pairs/dxPairKey.h"
#include "collision/pairs/dxSlotPair.h"
#include "core/dxRadixSort.h"
#include "threading/dxTaskRunner.h"

// The order of a kind of space.
class dxPairPlacer {
public:
    // Of a pair whose boxes overlap: the first word of its key, and in `swapped` whether b comes first in the
    // callback. Two pairs with the same first word have the same first geom. False: upstream does not bring this pair.
    virtual bool lead(dxMembers::Slot a, dxMembers::Slot b, std::uint64_t &word, bool &swapped) const = 0;

    // The other words, of a pair in the order of the callback. False: as above.
    virtual bool follow(dxMembers::Slot first, dxMembers::Slot second, dxPairKey &key) const = 0;

    // A pair with this member is about to be placed: it may be fetched from memory.
    virtual void expect(dxMembers::Slot slot) const = 0;

protected:
    ~dxPairPlacer() = default;
};

class dxKeptPairs {
public:
    // Brings `pairs`, which are those of the last call, up to date. Matches of geoms that may not meet are
    // left out.
    void update(const dxMembers &members, const std::vector<dxSlotPair> &matches,
                const dxPairPlacer &placer, dxTaskRunner &runner, std::vector<dxOrderedPair> &pairs);

private:
    struct Placed {
        dxPairKey key;
        dxOrderedPair pair;
    };
    using LongRun = std::vector<Placed>;  // a worker's memory for sorting one

    void sortByLead(const dxMembers &members, const std::vector<dxSlotPair> &matches,
                    const dxPairPlacer &placer, dxTaskRunner &runner);
    void placeAll(const dxMembers &members, const dxPairPlacer &placer, dxTaskRunner &runner);
    bool placeRuns(const dxMembers &members, const dxPairPlacer &placer, std::size_t begin, std::size_t end,
                   LongRun &longRun);
    void sortRun(std::size_t begin, std::size_t end, LongRun &longRun);
    void sortLongRun(std::size_t begin, std::size_t end, LongRun &run);
    void leaveOutUnplaced();
    void merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

    std::vector<dxPairKey> m_keys, m_nextKeys;  // of the pairs
    std::vector<dxOrderedPair> m_nextPairs;
    std::vector<dxPairKey> m_keptKeys;
    std::vector<dxOrderedPair> m_keptPairs;
    std::vector<LongRun> m_longRuns;  // by worker
    std::vector<dxSortItem> m_items, m_spare;  // first words, with the slots of first and second geoms
};
