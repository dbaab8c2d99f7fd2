#include "collision/dxOrderedSpace.h"

#include <utility>

#include "collision/dxNeighbourSearch.h"

#include "util.h"
#include "collision_space_internal.h"

namespace {

bool isDirty(const dxGeom *geom) { return (geom->gflags & GEOM_DIRTY) != 0; }

}  // namespace

bool dxMayMeet(const dxGeom *a, const dxGeom *b) {
    if (a->body == b->body && a->body != nullptr) return false;
    return (a->category_bits & b->collide_bits) != 0 || (b->category_bits & a->collide_bits) != 0;
}

// The slot is kept in a field that upstream's simple and hash spaces leave unused.
dxOrderedSpace::Slot dxOrderedSpace::slotOf(const dxGeom *geom) {
    return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(geom->tome_ex) - 1);
}

dxOrderedSpace *dxOrderedSpace::of(const dxGeom *geom) {
    dxSpace *const space = geom->parent_space;
    const bool isOrdered =
        space != nullptr && (space->type == dSimpleSpaceClass || space->type == dHashSpaceClass);
    return isOrdered ? static_cast<dxOrderedSpace *>(space) : nullptr;
}

dxOrderedSpace::dxOrderedSpace(dSpaceID parent, int kind) : dxSpace(parent) { type = kind; }

dxOrderedSpace::~dxOrderedSpace() {
    for (Slot slot = 0; slot < m_members.end(); ++slot)
        if (dxGeom *const geom = m_members[slot].geom) geom->tome_ex = nullptr;
}

void dxOrderedSpace::add(dxGeom *geom) {
    dxSpace::add(geom);
    const Slot slot = m_members.add(geom);
    geom->tome_ex = reinterpret_cast<dxGeom **>(static_cast<std::uintptr_t>(slot) + 1);
}

void dxOrderedSpace::remove(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    dxSpace::remove(geom);
    geom->tome_ex = nullptr;
    m_members.remove(slot);
}

void dxOrderedSpace::setSearch(std::unique_ptr<dxPairSearch> search) {
    m_search = std::move(search);
    startAnew();
}

void dxOrderedSpace::startAnew() {
    m_pairs.clear();
    m_ownSearch.reset();
    m_kept.reset();
    for (Slot slot = 0; slot < m_members.end(); ++slot)
        if (m_members[slot].geom != nullptr) m_members.markChanged(slot);
}

// Upstream stops at the first geom that is clean, and so do we. Ranks are given from the front downwards, at
// once, because a user's bounding-box function may leave by an exception.
void dxOrderedSpace::cleanGeoms() {
    lock_count++;
    dxRank next = m_members.firstOf(count);
    dxGeom *geom = first;
    for (; geom != nullptr && isDirty(geom); geom = geom->next) {
        if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
        geom->recomputeAABB();
        dIASSERT((geom->gflags & GEOM_AABB_BAD) == 0);
        geom->gflags &= ~GEOM_DIRTY;
        rank(geom, next--);
    }
    if (m_members.unranked() != 0 || m_irregular) rankBehindClean(geom, next);
    lock_count--;
}

void dxOrderedSpace::rank(dxGeom *geom, dxRank rank) {
    const Slot slot = slotOf(geom);
    m_members.setRank(slot, rank);
    m_members.markChanged(slot);
}

// A geom that was clean when it was added stands, clean, before the dirty ones, and upstream never gets to
// those: they keep their old boxes, and an assertion fails where they meet. While there are such geoms, all
// ranks are given anew.
void dxOrderedSpace::rankBehindClean(dxGeom *geom, dxRank next) {
    const bool wasIrregular = m_irregular;
    m_irregular = false;
    for (; geom != nullptr && (wasIrregular || m_members.unranked() != 0 || isDirty(geom)); geom = geom->next) {
        m_irregular = m_irregular || isDirty(geom);
        rank(geom, next--);
    }
}

bool dxOrderedSpace::makeReady() {
    cleanGeoms();
    if (m_irregular) return false;
    if (m_members.changed().empty()) return true;
    for (const Slot slot : m_members.changed())
        if (const dxGeom *const geom = m_members[slot].geom) m_members.setBounds(slot, dxBounds(geom->aabb));
    update(m_pairs);
    m_members.forgetChanges();
    return true;
}

void dxOrderedSpace::update(std::vector<dxOrderedPair> &pairs) {
    if (m_search == nullptr && m_ownSearch == nullptr) m_ownSearch.reset(new dxNeighbourSearch);
    if (m_kept == nullptr) m_kept.reset(new dxKeptPairs);
    m_matches.clear();
    (m_search != nullptr ? m_search : m_ownSearch)->search(m_members, m_matches);
    m_kept->update(m_members, m_matches, *this, pairs);
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
