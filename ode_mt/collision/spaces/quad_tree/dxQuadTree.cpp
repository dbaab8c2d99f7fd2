#include "collision/spaces/quad_tree/dxQuadTree.h"

#include <new>

#include "seams/assertions.h"

namespace {

void requireOrder(bool isInOrder, const char *assertion, unsigned line) {
    if (!isInOrder) dxFailUpstreamAssertion(assertion, "Create", "collision_quadtreespace.cpp", line);
}

// Depth from which on a tree has more blocks than dxQuadTree::Block can number, and more than memory holds.
constexpr int kTooDeep = 16;

std::size_t blocksOf(int depth) {
    if (depth >= kTooDeep) throw std::bad_alloc();
    std::size_t blocks = 1;
    for (std::size_t ofLevel = 4; depth > 0; --depth, ofLevel *= 4) blocks += ofLevel;
    return blocks;
}

}  // namespace

// The upper edges are the next larger numbers, because upstream's tree includes a geom on its upper edge.
dxQuadTree::dxQuadTree(const dReal *centre, const dReal *extents, int depth) {
    const auto upperEdge = [&](int axis) {
        return static_cast<dReal>(dNextAfter(centre[axis] + extents[axis], static_cast<dReal>(dInfinity)));
    };
    m_nodes.reserve(blocksOf(depth));
    build({centre[0] - extents[0], upperEdge(0), centre[1] - extents[1], upperEdge(1)}, kRoot, depth);
}

void dxQuadTree::build(const Area &area, Block parent, int depth) {
    requireOrder(area.lowX <= area.highX, "MinX <= MaxX", kQuadTreeOrderXLine);
    requireOrder(area.lowY <= area.highY, "MinZ <= MaxZ", kQuadTreeOrderZLine);
    const Block block = size();
    m_nodes.push_back({area, parent, 0});
    if (depth > 0) {
        // Rounded as in upstream, which adds half the width to the lower edge.
        const dReal middleX = area.lowX + (area.highX - area.lowX) / 2;
        const dReal middleY = area.lowY + (area.highY - area.lowY) / 2;
        build({area.lowX, middleX, area.lowY, middleY}, block, depth - 1);
        build({area.lowX, middleX, middleY, area.highY}, block, depth - 1);
        build({middleX, area.highX, area.lowY, middleY}, block, depth - 1);
        build({middleX, area.highX, middleY, area.highY}, block, depth - 1);
    }
    m_nodes[block].end = size();
}

// Searches outwards for a block that contains the box, and from there inwards.
dxQuadTree::Block dxQuadTree::find(const dReal *aabb, Block from) const {
    while (!m_nodes[from].area.has(aabb)) {
        if (from == kRoot) return kRoot;
        from = m_nodes[from].parent;
    }
    for (Block quarter = from + 1; quarter < endOf(from);) {
        if (m_nodes[quarter].area.has(aabb))
            from = quarter++;
        else
            quarter = endOf(quarter);
    }
    return from;
}

bool dxQuadTree::mayMeet(Block block, const dReal *aabb) const {
    const Area &area = m_nodes[block].area;
    return !(aabb[0] >= area.highX || aabb[1] < area.lowX || aabb[2] >= area.highY || aabb[3] < area.lowY);
}
