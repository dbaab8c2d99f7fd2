// The callbacks of quad-tree spaces, in upstream's order: of a geom with those behind it in its block, then with those in the blocks within, from
// the root on. docs/collision.md. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxQuadTreeParts.h"

class dxQuadTreeWalker final : public dxSpaceWalker {
public:
    dxQuadTreeWalker(dxOrderedSpace &space, const dxQuadTree &tree, const dxQuadTreeCleaner &cleaner, dxQuadTreePairOrder &order)
        : m_space(space), m_tree(tree), m_cleaner(cleaner), m_order(order) {}

    void deliver(void *data, dNearCallback *callback) override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;

private:
    using Block = dxQuadTree::Block;
    using Slot = dxMembers::Slot;

    struct Visit;

    Block blockOf(Slot slot) const { return m_cleaner.blockOf(slot); }
    void deliverInPlace(void *data, dNearCallback *callback);
    template <class Meet>
    void withOverlapping(const dxBounds &box, const Meet &meet);
    void collideMember(void *data, dxGeom *geom, dNearCallback *callback);
    void collideOther(void *data, dxGeom *geom, dNearCallback *callback);
    void walkMember(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after);
    void walkOther(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after);

    dxOrderedSpace &m_space;
    const dxQuadTree &m_tree;
    const dxQuadTreeCleaner &m_cleaner;
    dxQuadTreePairOrder &m_order;
    std::size_t m_comparisons = 0;  // of boxes, where all pairs were last found anew
};
