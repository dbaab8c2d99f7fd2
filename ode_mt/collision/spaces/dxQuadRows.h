// All pairs of a quad-tree space, found anew: each geom with those behind it in its block and in the blocks within, which stand together in
// the order of ranks (docs/collision-order.md). In other blocks nothing overlaps it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/spaces/dxQuadTree.h"

class dxQuadRows final : public dxPairRows {
public:
    using Block = dxQuadTree::Block;

    explicit dxQuadRows(const dxQuadTree &tree) : m_tree(tree) {}

    void clear() {
        dxPairRows::clear();
        m_blocks.clear();
    }
    // Adds a geom behind the others. Requires that blocks do not fall.
    void push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box, Block block) {
        dxPairRows::push(geom, slot, filter, box);
        m_blocks.push_back(block);
    }
    // Requires a call after the last push().
    void finish();
    // Returns how many boxes are compared to find all rows.
    std::size_t candidates() const { return m_candidates; }

    std::size_t find(std::size_t row) override {
        return m_areFew ? findOneByOne(row, m_ends[row]) : keepAgreeing(row, findBetween(row + 1, m_ends[row], m_boxes, box(row)));
    }

private:
    const dxQuadTree &m_tree;
    std::vector<Block> m_blocks;
    std::vector<std::uint32_t> m_ends;  // by row: behind the last element in its block and those within
    std::vector<std::uint32_t> m_open;  // scratch: the first rows of blocks around the one at hand
    std::size_t m_candidates = 0;
    bool m_areFew = false;  // too few for vectors
};
