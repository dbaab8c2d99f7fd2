#include "collision/dxOrderedSpace.h"

#include <algorithm>

#include "util.h"
#include "collision_space_internal.h"

namespace {

bool isDirty(const dxGeom *geom) { return (geom->gflags & GEOM_DIRTY) != 0; }

// The tests of upstream's collideAABBs that do not depend on boxes.
bool mayMeet(const dxGeom *a, const dxGeom *b) {
    if (a->body == b->body && a->body != nullptr) return false;
    return (a->category_bits & b->collide_bits) != 0 || (b->category_bits & a->collide_bits) != 0;
}

}  // namespace

// The slot is kept in a field that upstream's simple and hash spaces leave unused.
dxOrderedSpace::Slot dxOrderedSpace::slotOf(const dxGeom *geom) {
    return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(geom->tome_ex) - 1);
}

void dxOrderedSpace::setSlot(dxGeom *geom, Slot slot) {
    geom->tome_ex = reinterpret_cast<dxGeom **>(static_cast<std::uintptr_t>(slot) + 1);
}

dxOrderedSpace *dxOrderedSpace::of(const dxGeom *geom) {
    dxSpace *const space = geom->parent_space;
    const bool tracks = space != nullptr && (space->type == dSimpleSpaceClass || space->type == dHashSpaceClass);
    return tracks ? static_cast<dxOrderedSpace *>(space) : nullptr;
}

dxOrderedSpace::dxOrderedSpace(dSpaceID parent, int kind) : dxSpace(parent) { type = kind; }

dxOrderedSpace::~dxOrderedSpace() {
    for (const Member &member : m_members)
        if (member.geom != nullptr) member.geom->tome_ex = nullptr;
}

void dxOrderedSpace::add(dxGeom *geom) {
    dxSpace::add(geom);
    Slot slot;
    if (m_free.empty()) {
        slot = static_cast<Slot>(m_members.size());
        m_members.emplace_back();
        m_isChanged.push_back(false);
    } else {
        slot = m_free.back();
        m_free.pop_back();
    }
    m_members[slot].geom = geom;
    setSlot(geom, slot);
    ++m_unranked;
    markChanged(slot);
}

void dxOrderedSpace::remove(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    const bool isMember = geom->parent_space == this;
    dxSpace::remove(geom);
    if (!isMember) return;
    geom->tome_ex = nullptr;
    Member &member = m_members[slot];
    if (member.rank == 0) --m_unranked;
    if (member.placed) {
        m_neighbours.remove(slot);
        memberGone(slot);
        markChanged(slot);
        m_gone.push_back(slot);
    } else {
        m_free.push_back(slot);
    }
    member = Member();
}

void dxOrderedSpace::markChanged(Slot slot) {
    if (m_isChanged[slot]) return;
    m_isChanged[slot] = true;
    m_changed.push_back(slot);
}

void dxOrderedSpace::filtersChanged(dxGeom *geom) { markChanged(slotOf(geom)); }

void dxOrderedSpace::allChanged() {
    for (Slot slot = 0; slot < m_members.size(); ++slot)
        if (m_members[slot].geom != nullptr) markChanged(slot);
}

// Upstream stops at the first geom that is clean, and so do we. Ranks are given from the front downwards, at
// once, because a user's bounding-box function may leave by an exception.
void dxOrderedSpace::cleanGeoms() {
    lock_count++;
    dxRank rank = m_lastRank += static_cast<dxRank>(count);
    dxGeom *geom = first;
    for (; geom != nullptr && isDirty(geom); geom = geom->next) {
        if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
        geom->recomputeAABB();
        dIASSERT((geom->gflags & GEOM_AABB_BAD) == 0);
        geom->gflags &= ~GEOM_DIRTY;
        rankFront(geom, rank--);
    }
    if (m_unranked != 0 || m_irregular) rankRest(geom, rank);
    lock_count--;
}

void dxOrderedSpace::rankFront(dxGeom *geom, dxRank rank) {
    const Slot slot = slotOf(geom);
    if (m_members[slot].rank == 0) --m_unranked;
    m_members[slot].rank = rank;
    markChanged(slot);
}

// A geom that was clean when it was added stands, clean, before the dirty ones, and upstream never gets to
// those: they keep their old boxes, and an assertion fails where they meet. While there are such geoms, all
// ranks are given anew.
void dxOrderedSpace::rankRest(dxGeom *geom, dxRank rank) {
    const bool wasIrregular = m_irregular;
    m_irregular = false;
    for (; geom != nullptr && (wasIrregular || m_unranked != 0 || isDirty(geom)); geom = geom->next) {
        m_irregular = m_irregular || isDirty(geom);
        rankFront(geom, rank--);
    }
}

bool dxOrderedSpace::refresh() {
    if (m_irregular) return false;
    if (m_changed.empty()) return true;
    updateMembers();
    m_found.clear();
    for (const Slot slot : m_changed)
        if (m_members[slot].geom != nullptr) findPairs(slot);
    mergePairs();
    forgetChanges();
    return true;
}

void dxOrderedSpace::updateMembers() {
    for (const Slot slot : m_changed) {
        Member &member = m_members[slot];
        if (member.geom == nullptr) continue;
        member.bounds = dxBounds(member.geom->aabb);
        if (member.placed)
            m_neighbours.move(slot, member.bounds);
        else
            m_neighbours.insert(slot, member.bounds);
        member.placed = true;
        boxChanged(slot, member.geom);
    }
}

void dxOrderedSpace::findPairs(Slot slot) {
    const Member &member = m_members[slot];
    for (const dxNeighbours::Candidate &candidate : m_neighbours.of(slot)) {
        const Slot otherSlot = candidate.slot;
        if (m_isChanged[otherSlot] && otherSlot < slot) continue;  // found from that side
        const Member &other = m_members[otherSlot];
        if (!member.bounds.overlaps(other.bounds) || !mayMeet(member.geom, other.geom)) continue;
        dxOrderedPair pair;
        bool swapped = false;
        if (!place(slot, otherSlot, pair.key, swapped)) continue;
        pair.first = swapped ? other.geom : member.geom;
        pair.second = swapped ? member.geom : other.geom;
        pair.slots[0] = slot;
        pair.slots[1] = otherSlot;
        m_found.push_back(pair);
    }
}

// The pairs of which neither geom changed keep their order; the new ones are sorted in.
void dxOrderedSpace::mergePairs() {
    std::sort(m_found.begin(), m_found.end());
    m_merged.clear();
    m_merged.reserve(m_pairs.size() + m_found.size());
    auto found = m_found.cbegin();
    for (const dxOrderedPair &pair : m_pairs) {
        if (m_isChanged[pair.slots[0]] || m_isChanged[pair.slots[1]]) continue;
        for (; found != m_found.cend() && *found < pair; ++found) m_merged.push_back(*found);
        m_merged.push_back(pair);
    }
    m_merged.insert(m_merged.end(), found, m_found.cend());
    m_pairs.swap(m_merged);
}

void dxOrderedSpace::forgetChanges() {
    for (const Slot slot : m_changed) m_isChanged[slot] = false;
    m_changed.clear();
    m_free.insert(m_free.end(), m_gone.begin(), m_gone.end());
    m_gone.clear();
}

void dxOrderedSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    dAASSERT(geom && callback);
    lock_count++;
    cleanGeoms();
    geom->recomputeAABB();
    for (dxGeom *member = first; member != nullptr; member = member->next)
        if (dxGeomIsEnabled(member)) collideAABBs(member, geom, data, callback);
    lock_count--;
}
