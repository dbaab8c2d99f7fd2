// The order of pairs of sweep-and-prune spaces: geoms are sorted along an axis, and each is paired with those that begin before it ends; pairs with
// geoms of infinite extent on that axis follow. docs/collision.md.
//
// Upstream tests which geoms are enabled before it sorts, so enabling or disabling a geom changes the pairs. The place of a pair depends on all
// sorted members: kept pairs get new places whenever a member changes (dxSapPairOrder). Where all pairs are found anew, a sweep finds them in order
// (dxSapRows). Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/overlap/dxAxisSap.h"
#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"
#include "collision/spaces/sweep_and_prune/dxSapCleaner.h"
#include "collision/spaces/sweep_and_prune/dxSapState.h"

// All pairs of a sweep-and-prune space, found anew by a sweep along its first axis, in upstream's order.
class dxSapRows final : public dxPairRows {
public:
    // Begins anew, with rows for a number of swept geoms.
    void clear(std::size_t swept);
    // Adds a swept geom. Requires the order of the sort.
    void pushSwept(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxSapBox &box);
    // Adds a geom that is infinite on the axis. Requires the order of the list, and that all swept geoms have been added.
    void pushInfinite(dxGeom *geom, Slot slot, const dxPairFilter &filter) { pushElement(geom, slot, filter); }
    // Adds the place of a swept geom in the sort. Requires the order of the list. Places are read only if there are infinite geoms.
    void pushPlace(std::uint32_t place) { m_places.push_back(place); }
    // Requires a call after the last geom was added.
    void finish() { makeRoom(); }

    // Each swept geom with those behind it; then each infinite one with those behind it and all that are swept.
    std::size_t find(std::size_t row) override;

private:
    std::size_t pairInfinite(std::size_t row);

    dxMeetBehindKernel m_meetBehind = dxKernelOfMeetBehind();
    dxSapColumns m_columns;  // of swept geoms
    std::vector<std::uint32_t> m_places;  // of swept geoms in the sort, in the order of the list
};

class dxSapPairOrder final : public dxSpacePairOrder {
public:
    using Slot = dxMembers::Slot;

    dxSapPairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs, dxSapState &state, const dxSapLists &lists)
        : m_geoms(geoms), m_pairs(pairs), m_state(state), m_lists(lists) {}

    // Return the members as of the last search for pairs: the swept and the infinite ones in the order of the list, and the swept ones in the order
    // of the sort.
    const std::vector<Slot> &swept() const { return m_swept; }
    const std::vector<Slot> &infinite() const { return m_infinite; }
    const std::vector<Slot> &inOrder() const { return m_inOrder; }
    dxSapRows &rows() { return m_rows; }

    bool prepare() override;
    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;

    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override;
    void prefetch(Slot slot) const override;

private:
    void sortSwept();
    void pairInfinite(std::vector<dxOrderedPair> &pairs) const;
    void pairIfMayMeet(Slot a, Slot b, std::vector<dxOrderedPair> &pairs) const;

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    dxSapState &m_state;
    const dxSapLists &m_lists;
    std::vector<Slot> m_swept, m_infinite;
    std::vector<float> m_keys;  // of m_swept
    std::vector<Slot> m_inOrder;
    bool m_isSorted = false;  // m_inOrder is that of m_swept
    dxSapRows m_rows;
    std::vector<dxSlotPair> m_matches;  // scratch
    std::size_t m_sweptPairs = 0;       // number of the pairs, all in front, of which both geoms are swept
};
