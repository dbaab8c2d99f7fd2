// The pairs of a space that overlap: kept from call to call and updated, or found anew at each call where that costs less (dxPairKeeping).
//
// find() is the second stage of a call of dSpaceCollide. It reads boxes, filters, presences and ranks of the members (dxSpaceGeoms) and writes
// pairs(). The order of pairs is that of the kind of space (dxSpacePairOrder).
//
// pairs() holds, in order, exactly the pairs for which upstream's collideAABBs passes its tests of body, bits and boxes and which
// upstream's space would bring to it. None of these can change while the space is locked, which it is while callbacks run.
// Threading: as dxOrderedSpace.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/dxBruteForce.h"
#include "collision/broadphase/dxPairKeeping.h"
#include "collision/broadphase/dxPairRows.h"
#include "collision/pairs/dxKeptPairs.h"
#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpaceParts.h"

// What a call knows when its second stage has ended.
enum class dxPairsFound {
    Kept,      // pairs() holds them
    RowByRow,  // nothing yet: dxSpaceWalker::deliverAnew() finds the pairs of a row as it calls back
    None       // pairs are not known, or an outer call iterates over pairs(): the geoms must be walked as upstream does
};

class dxSpacePairs {
public:
    // `mayKeep`: a broad phase can find the pairs of this space.
    dxSpacePairs(dxSpaceGeoms &geoms, dxSpacePairOrder &order, bool mayKeep)
        : m_geoms(geoms), m_order(order), m_mayKeep(mayKeep), m_keeping(geoms.pairOrder()) {}
    dxSpacePairs(const dxSpacePairs &) = delete;
    dxSpacePairs &operator=(const dxSpacePairs &) = delete;

    const std::vector<dxOrderedPair> &all() const { return m_pairs; }

    // Finds the pairs, if they can be known. Requires a locked space and clean geoms; `areRanked`: what dxSpaceCleaner::cleanToCollide() has
    // returned.
    dxPairsFound find(bool areRanked) {
        m_geoms.resumeRunner();
        if (!areRanked || !m_geoms.takeSwitches()) return dxPairsFound::None;
        const bool isUnchanged = m_geoms.members().changed().empty() && !m_areOutdated && !m_isCheckDue;
        return isUnchanged ? dxPairsFound::Kept : findChanged();
    }

    // Discards all pairs; they are found again at this update or at the next.
    void startAnew();
    // The same at the beginning of the next outermost call. Calls within the one in progress walk.
    void outdate() { m_areOutdated = true; }

    // Sets the broad phase; NULL: the default for the size of the space. Requires an unlocked space.
    void setBroadphase(std::unique_ptr<dxBroadphase> broadphase);
    dxBroadphase *broadphase() { return m_broadphase.get(); }
    const dxBroadphase *broadphase() const { return m_broadphase.get(); }

    // ---- For the pair order ----------------------------------------------------------------------------------------------------------

    // Updates pairs that are ordered by rank: by brute force while the space is small, else sorted.
    void updateRanked(std::vector<dxOrderedPair> &pairs, dxPairWork &work);
    // Updates the pairs by the broad phase and a sort.
    void updateSorted(std::vector<dxOrderedPair> &pairs, dxPairWork &work);
    // The same, with the additional pairs in `matches`.
    void findAndPlace(std::vector<dxBroadphase::Match> &matches, std::vector<dxOrderedPair> &pairs);

    // ---- For the walker --------------------------------------------------------------------------------------------------------------

    // Requires a call at the end of a call of dSpaceCollide that has found all pairs anew: the rows and the number of their pairs.
    void noteAnew(const dxPairRows &rows, std::size_t pairs);
    // The same with the work that it took, except for dxPairWork::changed, which is filled in here.
    void noteAnew(dxPairWork work);

private:
    dxPairsFound findChanged();
    dxPairsFound updateKept();
    dxPairsFound findAnew();
    void collectRows(dxPairRows &rows);
    void replaceBroadphase(std::unique_ptr<dxBroadphase> broadphase);
    void giveUp();
    void forget();
    bool isTooMany(std::size_t pairs) const;

    dxSpaceGeoms &m_geoms;
    dxSpacePairOrder &m_order;
    const bool m_mayKeep;
    std::vector<dxOrderedPair> m_pairs;
    std::unique_ptr<dxBruteForcePairs> m_bruteForce;  // while the space is small
    std::unique_ptr<dxBroadphase> m_broadphase, m_defaultBroadphase;
    std::vector<dxBroadphase::Match> m_matches;
    std::unique_ptr<dxKeptPairs> m_kept;
    dxPairKeeping m_keeping;
    std::size_t m_pairsAnew = 0;  // number of pairs of the last call that found all anew
    bool m_areOutdated = false;   // startAnew() is due
    bool m_isCheckDue = false;    // dxSpacePairOrder::requireValid()
    unsigned m_updates = 0;       // number of calls that have brought kept pairs up to date
    bool m_arePairsKept = true;   // the broad phase and m_kept know the pairs of unchanged members
};

// The order of pairs by the ranks of their geoms, which is that of simple spaces and quad trees: of two members the one with the higher rank is the
// first; pairs are ordered by the rank of the first, then by that of the second, both falling.
class dxRankPairOrder : public dxSpacePairOrder {
public:
    using Slot = dxMembers::Slot;

    dxRankPairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs) : m_geoms(geoms), m_pairs(pairs) {}

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override { m_pairs.updateRanked(pairs, work); }

    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const final {
        const dxMembers &members = m_geoms.members();
        const dxRank rankA = members[a].rank, rankB = members[b].rank;
        swapped = rankA < rankB;
        word = dxFrontFirst(std::max(rankA, rankB));
        return true;
    }
    bool secondaryKey(Slot /*first*/, Slot second, dxPairKey &key) const final {
        key.words[1] = dxFrontFirst(m_geoms.members()[second].rank);
        key.words[2] = key.words[3] = 0;
        return true;
    }
    void prefetch(Slot slot) const final { m_geoms.members().prefetch(slot); }

protected:
    ~dxRankPairOrder() = default;

    dxSpaceGeoms &geoms() { return m_geoms; }

private:
    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
};
