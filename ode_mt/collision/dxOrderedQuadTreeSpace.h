// The quad-tree space: each geom with those behind it in its block, then with those in the blocks within, from the root
// on. docs/collision-order.md.
//
// Unlike the other spaces it has a queue of its own for geoms that changed, and leaves the list of geoms as they came.
#pragma once

#include "collision/dxBlockRanks.h"
#include "collision/dxDirtyQueue.h"
#include "collision/dxOrderedSpace.h"
#include "collision/dxQuadTree.h"

class dxOrderedQuadTreeSpace final : public dxOrderedSpace {
public:
    dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents, int depth);

    dxGeom *getGeom(int index) override;
    void add(dxGeom *geom) override;
    void remove(dxGeom *geom) override;
    void dirty(dxGeom *geom) override;
    void computeAABB() override {}  // it is infinite
    void cleanGeoms() override;

private:
    using Block = dxQuadTree::Block;

    struct Rest;

    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;

    Block blockOf(Slot slot) const { return m_ranks.blockOf(members()[slot].rank); }
    dxRank nextRank(Block block);
    void rankAnew();
    void collideMember(void *data, dxGeom *geom, dNearCallback *callback);
    void collideOther(void *data, dxGeom *geom, dNearCallback *callback);

    dxQuadTree m_tree;
    dxBlockRanks m_ranks;
    dxDirtyQueue m_dirty;
};
