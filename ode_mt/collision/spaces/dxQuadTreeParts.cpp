#include "collision/spaces/dxQuadTreeParts.h"

#include <algorithm>

// A geom comes into the block of the box that it had last, until it is cleaned.
void dxQuadTreeCleaner::onAdded(dxGeom *geom, Slot slot) {
    m_geoms.members().setRank(slot, nextRank(m_tree.find(geom->aabb, dxQuadTree::kRoot)));
    m_dirty.push(geom, slot);
}

// The queue is emptied last: a user's bounding-box function may leave by an exception or a jump. One that has
// the space cleaned empties it at once.
void dxQuadTreeCleaner::clean() {
    m_geoms.mayHaveStaleGeoms();
    if (m_dirty.isEmpty()) return;
    m_geoms.space().lock_count++;
    const std::vector<dxGeom *> &geoms = m_dirty.geoms();
    m_geoms.computeBoxes(geoms);
    for (std::size_t i = 0; i < geoms.size(); ++i) {
        dxGeom *const geom = geoms[i];
        m_geoms.clean(geoms, i);
        const dxRank before = m_geoms.members()[dxSpaceGeoms::slotOf(geom)].rank;
        const Block from = m_ranks.blockOf(before), to = m_tree.find(geom->aabb, from);
        m_geoms.rank(geom, to == from ? before : nextRank(to));
    }
    m_dirty.clear();
    m_geoms.space().lock_count--;
}

// The block of a stale geom does not follow from its box.
bool dxQuadTreeCleaner::cleanToCollide() {
    clean();
    return m_geoms.isSure();
}

// A geom is also stale if it has another box, but not the block of that, in which upstream would not look for it.
bool dxQuadTreeCleaner::readAgain() {
    m_geoms.rankAgain();
    for (const dxGeom *geom = m_geoms.space().first; geom != nullptr; geom = geom->next) {
        const Slot slot = dxSpaceGeoms::slotOf(geom);
        if (m_dirty.has(slot)) continue;
        const Block block = blockOf(slot);
        if ((geom->gflags & GEOM_DIRTY) != 0 || m_tree.find(geom->aabb, block) != block) return true;
    }
    return false;
}

dxRank dxQuadTreeCleaner::nextRank(Block block) {
    if (m_ranks.isExhausted()) rankAnew();
    return m_ranks.next(block);
}

// In the order in which they are.
void dxQuadTreeCleaner::rankAnew() {
    dxMembers &members = m_geoms.members();
    std::vector<Slot> slots;
    for (Slot slot = 0; slot < members.end(); ++slot)
        if (members.geomIn(slot) != nullptr && members[slot].rank != 0) slots.push_back(slot);
    std::sort(slots.begin(), slots.end(), [&](Slot a, Slot b) { return members[a].rank < members[b].rank; });
    m_ranks.startAgain();
    for (const Slot slot : slots) members.setRank(slot, m_ranks.next(blockOf(slot)));
    m_pairs.startAnew();
}

// How many boxes a call compares that finds all pairs anew follows from how geoms lie in the tree. The rows tell it; they are gathered for that where
// there are none, or those of another number of geoms.
void dxQuadTreePairOrder::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    if (m_rows.geoms() > 2 * work.geoms || work.geoms > 2 * m_rows.geoms()) gatherRows();
    work.comparisons = m_rows.candidates();
    dxRankPairOrder::update(pairs, work);
}

dxPairRows &dxQuadTreePairOrder::gatherRows() {
    const dxMembers &members = geoms().members();
    const std::vector<dxSortItem> &order = m_boxes.update(members);
    m_rows.clear(order.size());
    for (const dxSortItem &item : order) {
        const dxMembers::Member &member = members[item.index];
        m_rows.push(member.geom, item.index, member.filter, member.bounds, m_ranks.blockOf(member.rank));
    }
    m_rows.finish();
    return m_rows;
}
