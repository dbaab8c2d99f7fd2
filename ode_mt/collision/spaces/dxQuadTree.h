// The blocks of upstream's quad tree: a rectangle of x and y, halved on both axes as many times as the tree
// is deep.
//
// Blocks are numbered in the order in which upstream visits them: a block, then its quarters with all that is
// in each, those of low x first, of two alike the one of low y. So the blocks within a block are the numbers
// that follow it. A block has its lower edges and not its upper ones; the quarters of a block share nothing
// and leave nothing out. The root also has whatever does not fit into it.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/common.h>

class dxQuadTree {
public:
    using Block = std::uint32_t;
    static constexpr Block kRoot = 0;

    // As dQuadTreeSpaceCreate. A rectangle inside out fails upstream's assertion.
    dxQuadTree(const dReal *centre, const dReal *extents, int depth);

    Block size() const { return static_cast<Block>(m_nodes.size()); }
    // One past the last block within the block.
    Block endOf(Block block) const { return m_nodes[block].end; }

    // Returns the block around a block other than the root.
    Block parentOf(Block block) const { return m_nodes[block].parent; }

    // Where upstream puts a box that was in block `from`: the smallest block that has all of it, as far as x
    // and y go. Only where a box inside out goes depends on where it was.
    Block find(const dReal *aabb, Block from) const;

    // Whether upstream looks for boxes that meet this one in the block, or passes it over.
    bool mayMeet(Block block, const dReal *aabb) const;

private:
    struct Area {
        dReal lowX, highX, lowY, highY;

        bool has(const dReal *aabb) const {
            return aabb[0] >= lowX && aabb[1] < highX && aabb[2] >= lowY && aabb[3] < highY;
        }
    };
    struct Node {
        Area area;
        Block parent, end;
    };

    void build(const Area &area, Block parent, int depth);

    std::vector<Node> m_nodes;
};
