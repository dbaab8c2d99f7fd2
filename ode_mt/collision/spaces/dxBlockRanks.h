// Ranks of geoms in the blocks of a quad tree: falling with the number of the block and, within one block, with the time
// since the geom came, because upstream puts what comes into a block before all that is in it.
//
// A rank is the block and a stamp, a number that rises with each geom that comes into any block. It stays right for as
// long as the geom stays in its block. Stamps run out in the end (for a tree ten deep, after 2^41), and then begin anew.
#pragma once

#include "collision/pairs/dxPairKey.h"
#include "collision/spaces/dxQuadTree.h"

class dxBlockRanks {
public:
    using Block = dxQuadTree::Block;

    static constexpr int kBits = 62;

    explicit dxBlockRanks(Block blocks, int bits = kBits) : m_last(blocks - 1), m_stampBits(bits) {
        for (Block block = m_last; block != 0; block >>= 1) --m_stampBits;
    }

    // There is no stamp left.
    bool isExhausted() const { return m_next >> m_stampBits != 0; }
    // Of a geom that comes into the block.
    dxRank next(Block block) { return static_cast<dxRank>(m_last - block) << m_stampBits | m_next++; }
    Block blockOf(dxRank rank) const { return m_last - static_cast<Block>(rank >> m_stampBits); }

    // All ranks so far are void.
    void startAgain() { m_next = 1; }

private:
    Block m_last;
    int m_stampBits;
    dxRank m_next = 1;
};
