// The quad-tree space: pairs each geom with those behind it in its block, then with those in the blocks within, from
// the root on. docs/collision.md.
#pragma once

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxQuadTree.h"
#include "collision/spaces/dxQuadTreeParts.h"
#include "collision/spaces/dxQuadTreeWalker.h"

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
