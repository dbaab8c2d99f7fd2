// The order of pairs by the ranks of their geoms, which is that of simple spaces and quad trees: of two members the one with the higher rank is the
// first; pairs are ordered by the first, then by the second. docs/collision.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"

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
