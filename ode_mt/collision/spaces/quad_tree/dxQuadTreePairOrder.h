// The order of pairs of quad-tree spaces: each geom with those behind it in its block, then with those in the blocks within, from the root on.
// docs/collision.md.
//
// Kept pairs are ordered by ranks (dxRankPairOrder), which tell the blocks. Where all pairs are found anew, they are found in this order
// (dxQuadRows). Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxOrderedBoxes.h"
#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/overlap/dxPackedBoxes.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/quad_tree/dxQuadTree.h"
#include "collision/spaces/quad_tree/dxQuadTreeCleaner.h"

// All pairs of a quad-tree space, found anew. In the order of ranks, a geom is followed by those behind it in its block and then by those in the
// blocks within; geoms in other blocks do not overlap it.
class dxQuadRows final : public dxPairRows {
public:
    using Block = dxQuadTree::Block;

    explicit dxQuadRows(const dxQuadTree &tree) : m_tree(tree) {}

    // Begins anew, with room for a number of geoms.
    void clear(std::size_t maxGeoms);
    // Adds a geom behind the others. Requires that blocks do not fall.
    void push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box, Block block) {
        m_packed.set(geoms(), box);
        m_blocks.push_back(block);
        pushElement(geom, slot, filter);
    }
    // Requires a call after the last push().
    void finish();
    // Returns how many boxes are compared to find all rows.
    std::size_t candidates() const { return m_candidates; }

    std::size_t find(std::size_t row) override;

private:
    std::size_t findPacked(std::size_t row);

    const dxQuadTree &m_tree;
    dxOverlappingSlotsKernel m_overlappingSlots = dxKernelOfOverlappingSlots();
    dxPackedBoxes m_packed;
    std::vector<Block> m_blocks;
    std::vector<std::uint32_t> m_ends;  // by row: one past the last element in its block and in the blocks within
    std::vector<std::uint32_t> m_open;  // scratch: the first rows of the blocks around the current row, outermost first
    std::size_t m_candidates = 0;
    bool m_areFew = false;  // there are too few candidates to fill columns
};

class dxQuadTreePairOrder final : public dxRankPairOrder {
public:
    dxQuadTreePairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs, const dxQuadTree &tree, const dxBlockRanks &ranks)
        : dxRankPairOrder(geoms, pairs), m_ranks(ranks), m_rows(tree) {}

    // The members in the order of ranks.
    dxOrderedBoxes &boxes() { return m_boxes; }
    dxQuadRows &rows() { return m_rows; }

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;

private:
    const dxBlockRanks &m_ranks;
    dxQuadRows m_rows;
    dxOrderedBoxes m_boxes;
};
