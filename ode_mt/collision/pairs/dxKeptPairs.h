// Ordered pairs that are kept from call to call: pairs of unchanged geoms keep their places, and new pairs are sorted
// by key and merged.
//
// A pair's key is computed in two steps. The primary key identifies the geom that reports the pair, and is sufficient for most of the sorting. The
// secondary key orders the few pairs of one geom: it is computed when these are adjacent and their common member is in the cache, and is written
// directly to its final place. Threading: one thread at a time; the runner's workers share the work.
#pragma once

#include <vector>

#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"
#include "core/dxRadixSort.h"
#include "threading/dxTaskRunner.h"

// The order of pairs in a kind of space.
class dxPairKeys {
public:
    // Computes the primary key of a pair whose boxes overlap, and in `swapped` whether b is first in the callback. Two
    // pairs with the same primary key have the same first geom. Returns false if upstream does not report this pair.
    virtual bool primaryKey(dxMembers::Slot a, dxMembers::Slot b, std::uint64_t &word, bool &swapped) const = 0;

    // Computes the secondary key of a pair in the order of the callback. Returns false if upstream does not report this
    // pair.
    virtual bool secondaryKey(dxMembers::Slot first, dxMembers::Slot second, dxPairKey &key) const = 0;

    // Prefetches a member whose pair will be placed soon.
    virtual void prefetch(dxMembers::Slot slot) const = 0;

protected:
    ~dxPairKeys() = default;
};

class dxKeptPairs {
public:
    // Updates `pairs`, which are those of the last call. Matches of geoms whose filters exclude each other are dropped.
    void update(const dxMembers &members, const std::vector<dxSlotPair> &matches,
                const dxPairKeys &order, dxTaskRunner &runner, std::vector<dxOrderedPair> &pairs);

private:
    struct Placed {
        dxPairKey key;
        dxOrderedPair pair;
    };
    using LongRun = std::vector<Placed>;  // scratch of a worker that sorts a long run

    void sortByPrimaryKey(const dxMembers &members, const std::vector<dxSlotPair> &matches,
                    const dxPairKeys &order, dxTaskRunner &runner);
    void placeAll(const dxMembers &members, const dxPairKeys &order, dxTaskRunner &runner);
    bool placeRuns(const dxMembers &members, const dxPairKeys &order, std::size_t begin, std::size_t end,
                   LongRun &longRun);
    void sortRun(std::size_t begin, std::size_t end, LongRun &longRun);
    void sortLongRun(std::size_t begin, std::size_t end, LongRun &run);
    void removeUnplaced();
    void merge(const dxMembers &members, std::vector<dxOrderedPair> &pairs);

    std::vector<dxPairKey> m_keys, m_nextKeys;  // by place of the pair
    std::vector<dxOrderedPair> m_nextPairs;
    std::vector<dxPairKey> m_keptKeys;
    std::vector<dxOrderedPair> m_keptPairs;
    std::vector<LongRun> m_longRuns;  // by worker
    std::vector<dxSortItem> m_items, m_spare;  // primary keys, with the slots of first and second geoms
};
