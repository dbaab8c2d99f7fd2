// All pairs of a quad-tree space, found anew: each geom with those behind it in its block and in the blocks within, which stand together in
// the order of ranks (docs/collision.md). In other blocks nothing overlaps it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/overlap/dxPackedBoxes.h"
#include "collision/spaces/dxQuadTree.h"

class dxQuadRows final : public dxPairRows {
public:
    using Block = dxQuadTree::Block;

    explicit dxQuadRows(const dxQuadTree &tree) : m_tree(tree) {}

    // Begins with room for so many geoms.
    void clear(std::size_t mostGeoms);
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
    std::vector<std::uint32_t> m_ends;  // by row: behind the last element in its block and those within
    std::vector<std::uint32_t> m_open;  // scratch: the first rows of blocks around the one at hand
    std::size_t m_candidates = 0;
    bool m_areFew = false;  // too few to put boxes into columns
};
