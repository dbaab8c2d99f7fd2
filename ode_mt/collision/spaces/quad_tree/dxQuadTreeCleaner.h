// The cleaner of quad-tree spaces, with what it keeps from call to call: the queue of dirty geoms, and ranks that tell the block of each geom.
//
// Unlike the other kinds, these spaces have a queue of their own for geoms that changed, and leave the list of geoms in the order in which geoms were
// added. Threading: as dxOrderedSpace.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"
#include "collision/spaces/quad_tree/dxQuadTree.h"
#include "core/dxNoIndex.h"

// Queue of the dirty members, in the order of insertion, each once. Upstream may have a geom twice in its list; the second cleaning changes nothing.
class dxDirtyQueue {
public:
    using Slot = dxMembers::Slot;

    // Reserves memory for members in the slots below `slots`; the other functions then allocate nothing.
    void reserveMemory(Slot slots);
    // Does nothing if the member is in the queue.
    void push(dxGeom *geom, Slot slot);
    // Removes the member, if it is in the queue.
    void drop(Slot slot);
    void clear();

    bool isEmpty() const { return m_geoms.empty(); }
    bool has(Slot slot) const { return slot < m_places.size() && m_places[slot] != kNoIndex; }

    const std::vector<dxGeom *> &geoms();

private:
    void closeGaps();

    std::vector<dxGeom *> m_geoms;        // NULL: dropped
    std::vector<Slot> m_slots;            // of the geoms
    std::vector<std::uint32_t> m_places;  // by slot
    std::size_t m_dropped = 0;
};

// Ranks of geoms in the blocks of a tree. They fall with the number of the block. Within a block they rise with the time at which the geom entered
// it, because upstream adds a geom at the front of its block's list.
//
// A rank consists of the block and a stamp: a number that rises with each geom that enters any block. It is valid as long as the geom stays in its
// block. When all stamps are used (for a tree ten deep, after 2^41), all ranks are assigned again.
class dxBlockRanks {
public:
    using Block = dxQuadTree::Block;

    static constexpr int kBits = 62;

    explicit dxBlockRanks(Block blocks, int bits = kBits) : m_last(blocks - 1), m_stampBits(bits) {
        for (Block block = m_last; block != 0; block >>= 1) --m_stampBits;
    }

    // Returns whether all stamps are used.
    bool isExhausted() const { return m_next >> m_stampBits != 0; }
    // Returns the rank of a geom that enters the block.
    dxRank next(Block block) { return static_cast<dxRank>(m_last - block) << m_stampBits | m_next++; }
    Block blockOf(dxRank rank) const { return m_last - static_cast<Block>(rank >> m_stampBits); }

    // Returns a rank that separates blocks: geoms in the blocks before `end` have this rank or a higher one, all others a lower one.
    dxRank lowestBefore(Block end) const { return static_cast<dxRank>(m_last - (end - 1)) << m_stampBits; }

    // Invalidates all ranks so far.
    void startAgain() { m_next = 1; }

private:
    Block m_last;
    int m_stampBits;
    dxRank m_next = 1;
};

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
    void assignRanksAgain();

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    const dxQuadTree &m_tree;
    dxBlockRanks m_ranks;
    dxDirtyQueue m_dirty;
};
