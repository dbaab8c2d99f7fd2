// The order of pairs of sweep-and-prune spaces: geoms are sorted along an axis, and each is paired with those that begin before it
// ends; pairs with geoms of infinite extent on that axis follow. docs/collision.md.
//
// Upstream tests which geoms are enabled before it sorts, so enabling or disabling a geom changes the pairs. The place of a pair depends on all
// sorted members: kept pairs get new places whenever a member changes. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxSapLists.h"
#include "collision/spaces/dxSapRows.h"
#include "collision/spaces/dxSapState.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"

class dxSapPairOrder final : public dxSpacePairOrder {
public:
    using Slot = dxMembers::Slot;

    dxSapPairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs, dxSapState &state, const dxSapLists &lists)
        : m_geoms(geoms), m_pairs(pairs), m_state(state), m_lists(lists) {}

    // The members that were in pairs when these were last found: those that are swept and those that are infinite in the order of the list, and
    // those that are swept in the order of the sort.
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
    bool m_isSorted = false;  // since m_swept was taken
    dxSapRows m_rows;
    std::vector<std::uint32_t> m_places;  // by place in m_swept: that in m_inOrder
    std::vector<dxSlotPair> m_again;
    std::size_t m_sweptPairs = 0;  // of the pairs, those in front
};
