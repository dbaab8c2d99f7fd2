// The blocks of upstream's quad tree: a rectangle of x and y, halved along both axes on each level of the tree.
//
// Blocks are numbered in the order in which upstream visits them, which is pre-order: a block, then its quarters, by x, then by y, each with all
// blocks within it. So the blocks within a block have the numbers that follow its own. A block includes its lower edges and excludes its upper ones;
// its quarters partition it. The root also has the boxes that do not fit into it. Threading: constant after construction.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/common.h>

class dxQuadTree {
public:
    using Block = std::uint32_t;
    static constexpr Block kRoot = 0;

    // The arguments are those of dQuadTreeSpaceCreate. An inverted rectangle (min > max) fails upstream's assertion.
    dxQuadTree(const dReal *centre, const dReal *extents, int depth);

    Block size() const { return static_cast<Block>(m_nodes.size()); }
    // Returns one past the last block within the block.
    Block endOf(Block block) const { return m_nodes[block].end; }

    // Returns the block around a block other than the root.
    Block parentOf(Block block) const { return m_nodes[block].parent; }

    // Returns the block of a box that was in block `from`: the smallest block that contains it in x and y. The result depends on `from` only for an
    // inverted box.
    Block find(const dReal *aabb, Block from) const;

    // Returns whether upstream tests the boxes in the block against this one, or skips the block.
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
