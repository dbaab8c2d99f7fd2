// The cleaner and the pair order of quad-tree spaces.
//
// Unlike the other spaces these have a queue of their own for geoms that changed, and keep the list of geoms in the order of insertion. A rank tells
// the block of a geom, and its place in the block's list (dxBlockRanks). Threading: as dxOrderedSpace.
#pragma once

#include <vector>

#include "collision/broadphase/dxOrderedBoxes.h"
#include "collision/spaces/dxBlockRanks.h"
#include "collision/spaces/dxDirtyQueue.h"
#include "collision/spaces/dxQuadRows.h"
#include "collision/spaces/dxQuadTree.h"
#include "collision/spaces/dxRankPairOrder.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"

class dxQuadTreeCleaner final : public dxSpaceCleaner {
public:
    using Block = dxQuadTree::Block;

    dxQuadTreeCleaner(dxSpaceGeoms &geoms, dxSpacePairs &pairs, const dxQuadTree &tree)
        : m_geoms(geoms), m_pairs(pairs), m_tree(tree), m_ranks(tree.size()) {}

    const dxBlockRanks &ranks() const { return m_ranks; }
    // Returns the block of a member.
    Block blockOf(Slot slot) const { return m_ranks.blockOf(m_geoms.members()[slot].rank); }

    // dxSpace::cleanGeoms().
    void clean();
    // dxSpace::dirty().
    void makeDirty(dxGeom *geom) { m_dirty.push(geom, dxSpaceGeoms::slotOf(geom)); }

    void reserveMemory(Slot slots) override { m_dirty.reserveMemory(slots); }
    void onAdded(dxGeom *geom, Slot slot) override;
    void onRemoved(Slot slot) override { m_dirty.drop(slot); }
    bool cleanToCollide() override;
    bool readAgain() override;

private:
    dxRank nextRank(Block block);
    void rankAnew();

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    const dxQuadTree &m_tree;
    dxBlockRanks m_ranks;
    dxDirtyQueue m_dirty;
};

class dxQuadTreePairOrder final : public dxRankPairOrder {
public:
    dxQuadTreePairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs, const dxQuadTree &tree, const dxBlockRanks &ranks)
        : dxRankPairOrder(geoms, pairs), m_ranks(ranks), m_rows(tree) {}

    // The members in the order of ranks.
    dxOrderedBoxes &boxes() { return m_boxes; }
    dxQuadRows &rows() { return m_rows; }

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;

private:
    const dxBlockRanks &m_ranks;
    dxQuadRows m_rows;
    dxOrderedBoxes m_boxes;
};
