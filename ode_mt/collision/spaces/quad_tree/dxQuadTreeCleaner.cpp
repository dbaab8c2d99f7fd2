#include "collision/spaces/quad_tree/dxQuadTreeCleaner.h"

#include <algorithm>

#include "core/dxReserve.h"

// ---- Queue of dirty members ------------------------------------------------------------------------------------------------------------

// At most half of the queue consists of dropped entries (push).
void dxDirtyQueue::reserveMemory(Slot slots) {
    dxReserveCapacity(m_places, slots);
    dxReserveCapacity(m_geoms, 2 * std::size_t{slots} + 2);
    dxReserveCapacity(m_slots, 2 * std::size_t{slots} + 2);
}

void dxDirtyQueue::push(dxGeom *geom, Slot slot) {
    if (slot >= m_places.size()) m_places.resize(slot + 1, kNoIndex);
    if (m_places[slot] != kNoIndex) return;
    // Geoms may be added and removed without end before the space is cleaned.
    if (2 * m_dropped > m_geoms.size()) closeGaps();
    m_places[slot] = static_cast<std::uint32_t>(m_geoms.size());
    m_geoms.push_back(geom);
    m_slots.push_back(slot);
}

void dxDirtyQueue::drop(Slot slot) {
    if (slot >= m_places.size() || m_places[slot] == kNoIndex) return;
    m_geoms[m_places[slot]] = nullptr;
    m_places[slot] = kNoIndex;
    ++m_dropped;
}

void dxDirtyQueue::clear() {
    for (std::size_t place = 0; place < m_slots.size(); ++place)
        if (m_geoms[place] != nullptr) m_places[m_slots[place]] = kNoIndex;
    m_geoms.clear();
    m_slots.clear();
    m_dropped = 0;
}

const std::vector<dxGeom *> &dxDirtyQueue::geoms() {
    if (m_dropped != 0) closeGaps();
    return m_geoms;
}

void dxDirtyQueue::closeGaps() {
    std::size_t to = 0;
    for (std::size_t from = 0; from < m_geoms.size(); ++from) {
        if (m_geoms[from] == nullptr) continue;
        m_places[m_slots[from]] = static_cast<std::uint32_t>(to);
        m_geoms[to] = m_geoms[from];
        m_slots[to++] = m_slots[from];
    }
    m_geoms.resize(to);
    m_slots.resize(to);
    m_dropped = 0;
}

// ---- Cleaning --------------------------------------------------------------------------------------------------------------------------

// Until it is cleaned, a geom is in the block of the box that it last had.
void dxQuadTreeCleaner::onAdded(dxGeom *geom, Slot slot) {
    m_geoms.members().setRank(slot, nextRank(m_tree.find(geom->aabb, dxQuadTree::kRoot)));
    m_dirty.push(geom, slot);
}

// The queue is emptied last, because a user's bounding-box function may leave by an exception or a jump. One that has the space cleaned empties it
// early, which ends the loop.
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

// The block of a stale geom does not follow from its box, so pairs are not known then.
bool dxQuadTreeCleaner::cleanToCollide() {
    clean();
    return m_geoms.isSure();
}

// A geom is also stale if its box has changed and belongs to another block: upstream goes on looking for it in the old one.
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
    if (m_ranks.isExhausted()) assignRanksAgain();
    return m_ranks.next(block);
}

// The order of members stays.
void dxQuadTreeCleaner::assignRanksAgain() {
    dxMembers &members = m_geoms.members();
    std::vector<Slot> slots;
    for (Slot slot = 0; slot < members.end(); ++slot)
        if (members.geomIn(slot) != nullptr && members[slot].rank != 0) slots.push_back(slot);
    std::sort(slots.begin(), slots.end(), [&](Slot a, Slot b) { return members[a].rank < members[b].rank; });
    m_ranks.startAgain();
    for (const Slot slot : slots) members.setRank(slot, m_ranks.next(blockOf(slot)));
    m_pairs.startAnew();
}
