// Ranks of geoms in the blocks of a quad tree. They fall with the number of the block and, within one block, with the
// time since the geom was added, because upstream adds a geom at the front of its block's list.
//
// A rank is the block and a stamp, a number that rises with each geom that comes into any block. It is valid as long as
// the geom stays in its block. Stamps are exhausted in the end (for a tree ten deep, after 2^41), and all ranks are
// then assigned again.
#pragma once

#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxQuadTree.h"

class dxBlockRanks {
public:
    using Block = dxQuadTree::Block;

    static constexpr int kBits = 62;

    explicit dxBlockRanks(Block blocks, int bits = kBits) : m_last(blocks - 1), m_stampBits(bits) {
        for (Block block = m_last; block != 0; block >>= 1) --m_stampBits;
    }

    // Returns whether all stamps are used.
    bool isExhausted() const { return m_next >> m_stampBits != 0; }
    // Returns the rank of a geom that enters the block.
    dxRank next(Block block) { return static_cast<dxRank>(m_last - block) << m_stampBits | m_next++; }
    Block blockOf(dxRank rank) const { return m_last - static_cast<Block>(rank >> m_stampBits); }

    // Returns a rank that is not above that of any geom in the blocks before `end`, and above those of all others.
    dxRank lowestBefore(Block end) const { return static_cast<dxRank>(m_last - (end - 1)) << m_stampBits; }

    // Invalidates all ranks so far.
    void startAgain() { m_next = 1; }

private:
    Block m_last;
    int m_stampBits;
    dxRank m_next = 1;
};
