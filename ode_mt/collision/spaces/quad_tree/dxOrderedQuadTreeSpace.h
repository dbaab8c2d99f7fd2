// The quad-tree space, and its callbacks (dxQuadTreeWalker). docs/collision.md. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/quad_tree/dxQuadTree.h"
#include "collision/spaces/quad_tree/dxQuadTreeCleaner.h"
#include "collision/spaces/quad_tree/dxQuadTreePairOrder.h"

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
    std::size_t m_comparisons = 0;  // number of boxes compared when all pairs were last found anew
};

class dxOrderedQuadTreeSpace final : public dxOrderedSpace {
public:
    dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents, int depth);
    ~dxOrderedQuadTreeSpace() override;

    dxGeom *getGeom(int index) override;
    void dirty(dxGeom *geom) override { m_cleaner.makeDirty(geom); }
    void computeAABB() override {}  // it is infinite
    void cleanGeoms() override { m_cleaner.clean(); }

private:
    dxQuadTree m_tree;
    dxQuadTreeCleaner m_cleaner;
    dxQuadTreePairOrder m_order;
    dxQuadTreeWalker m_walker;
};
