// The quad-tree space: pairs each geom with those behind it in its block, then with those in the blocks within, from
// the root on. docs/collision-order.md.
//
// Unlike the other spaces it has a queue of its own for geoms that changed, and keeps the list of geoms in the order of
// insertion.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broadphase/dxOrderedBoxes.h"
#include "collision/spaces/dxBlockRanks.h"
#include "collision/spaces/dxDirtyQueue.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxQuadRows.h"
#include "collision/spaces/dxQuadTree.h"

class dxOrderedQuadTreeSpace final : public dxOrderedSpace {
public:
    dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents, int depth);
    ~dxOrderedQuadTreeSpace() override;

    dxGeom *getGeom(int index) override;
    void dirty(dxGeom *geom) override;
    void computeAABB() override {}  // it is infinite
    void cleanGeoms() override;

private:
    using Block = dxQuadTree::Block;

    struct Visit;

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    bool requireRanks() override;
    bool hasStrayMembers() const override;
    bool mayCome(const dxGeom *geom) const override;
    void reserveMemory(Slot slots) override;
    void comes(dxGeom *geom, Slot slot) override;
    void goes(dxGeom *geom, Slot slot) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;

    Block blockOf(Slot slot) const { return m_ranks.blockOf(members()[slot].rank); }
    void deliverInPlace(void *data, dNearCallback *callback);
    dxRank nextRank(Block block);
    void rankAnew();
    template <class Meet>
    void withOverlapping(const dxBounds &box, const Meet &meet);
    void collideMember(void *data, dxGeom *geom, dNearCallback *callback);
    void collideOther(void *data, dxGeom *geom, dNearCallback *callback);
    void walkMember(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after);
    void walkOther(void *data, dxGeom *geom, dNearCallback *callback, dxGeom *after);

    dxQuadTree m_tree;
    dxBlockRanks m_ranks;
    dxDirtyQueue m_dirty;
    dxQuadRows m_rows;
    dxOrderedBoxes m_order;
    std::size_t m_comparisons = 0;  // of boxes, where all pairs were last found anew
};
