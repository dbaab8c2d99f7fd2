#include "collision/dxOrderedSpace.h"

#include <cstring>
#include <utility>

#include "collision/dxAdaptiveSearch.h"
#include "collision/dxPairPrefetch.h"

#include "util.h"
#include "collision_space_internal.h"

namespace {

// Geoms that one worker takes at once: some ten microseconds.
constexpr std::size_t kBoxPiece = 128;

// Geoms between asking the memory for one's place and computing its box.
constexpr std::size_t kBoxesAhead = 4;

bool isDirty(const dxGeom *geom) { return (geom->gflags & GEOM_DIRTY) != 0; }

// In a smaller space the list is walked as fast.
constexpr int kLeastIndexed = 16;

// As upstream's collide2.
void collideFrom(dxGeom *member, void *data, dxGeom *geom, dNearCallback *callback) {
    for (; member != nullptr; member = member->next)
        if (dxGeomIsEnabled(member)) collideAABBs(member, geom, data, callback);
}

dxMeetingFilter filterOf(const dxGeom *geom) { return {geom->body, geom->category_bits, geom->collide_bits}; }

bool hasBoxOfItsOwn(const dxGeom *geom) {
    return geom->type <= dConvexClass || geom->type == dTriMeshClass || geom->type == dHeightfieldClass;
}

}  // namespace

// The slot is kept in a field that upstream's simple and hash spaces leave unused.
dxOrderedSpace::Slot dxOrderedSpace::slotOf(const dxGeom *geom) {
    return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(geom->tome_ex) - 1);
}

dxOrderedSpace *dxOrderedSpace::from(dxSpace *space) {
    const bool isOrdered =
        space != nullptr && (space->type == dSimpleSpaceClass || space->type == dHashSpaceClass);
    return isOrdered ? static_cast<dxOrderedSpace *>(space) : nullptr;
}

dxOrderedSpace *dxOrderedSpace::of(const dxGeom *geom) { return from(geom->parent_space); }

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
    if (m_index != nullptr) m_index->drop(slot);
}

void dxOrderedSpace::filtersChanged(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    m_members.setFilter(slot, filterOf(geom));
    m_members.markChanged(slot);
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

void dxOrderedSpace::collideShared(dxTaskRunner &runner, void *data, dNearCallback *callback) {
    if (m_ahead == nullptr) m_ahead.reset(new dxContactsAhead);
    const dxContactsAhead::Scope scope(*m_ahead, runner);
    m_runner = &runner;
    collide(data, callback);
    m_runner = nullptr;
}

bool dxOrderedSpace::makeReadyShared(dxTaskRunner &runner) {
    m_runner = &runner;
    const bool isReady = makeReady();
    m_runner = nullptr;
    return isReady;
}

// Upstream stops at the first geom that is clean, and so do we. Ranks are given from the front downwards, at
// once, because a user's bounding-box function may leave by an exception.
void dxOrderedSpace::cleanGeoms() {
    lock_count++;
    dxRank next = m_members.firstOf(count);
    gatherDirty();
    computeBoxes();
    for (std::size_t i = 0; i < m_dirty.size(); ++i) {
        dxGeom *const geom = m_dirty[i];
        if (i + kBoxesAhead < m_dirty.size()) dxPairPrefetch::place(m_dirty[i + kBoxesAhead]);
        if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
        geom->recomputeAABB();
        dIASSERT((geom->gflags & GEOM_AABB_BAD) == 0);
        geom->gflags &= ~GEOM_DIRTY;
        rank(geom, next--);
    }
    dxGeom *const clean = m_dirty.empty() ? first : m_dirty.back()->next;
    if (m_members.unranked() != 0 || m_irregular) rankBehindClean(clean, next);
    lock_count--;
}

void dxOrderedSpace::gatherDirty() {
    m_dirty.clear();
    for (dxGeom *geom = first; geom != nullptr && isDirty(geom); geom = geom->next) m_dirty.push_back(geom);
}

// Ahead of cleaning, of the built-in classes whose boxes depend on nothing but themselves and their bodies.
void dxOrderedSpace::computeBoxes() {
    if (m_runner == nullptr || m_dirty.size() < kBoxPiece) return;
    m_runner->forPieces(m_dirty.size(), kBoxPiece, [this](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kBoxesAhead < end) dxPairPrefetch::place(m_dirty[i + kBoxesAhead]);
            if (hasBoxOfItsOwn(m_dirty[i])) m_dirty[i]->recomputeAABB();
        }
    });
}

void dxOrderedSpace::rank(dxGeom *geom, dxRank rank) {
    const Slot slot = slotOf(geom);
    m_members.setRank(slot, rank);
    m_members.setBounds(slot, dxBounds(geom->aabb), filterOf(geom));
    m_members.markChanged(slot);
    if (m_index != nullptr) m_index->loosen(slot);
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
    update(m_pairs);
    m_members.forgetChanges();
    return true;
}

void dxOrderedSpace::update(std::vector<dxOrderedPair> &pairs) {
    if (m_search == nullptr && m_ownSearch == nullptr) m_ownSearch.reset(new dxAdaptiveSearch);
    if (m_kept == nullptr) m_kept.reset(new dxKeptPairs);
    m_matches.clear();
    (m_search != nullptr ? m_search : m_ownSearch)->search(m_members, runner(), m_matches);
    m_kept->update(m_members, m_matches, *this, runner(), pairs);
}

void dxOrderedSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    dAASSERT(geom && callback);
    lock_count++;
    cleanGeoms();
    geom->recomputeAABB();
    if (m_irregular || count < kLeastIndexed)
        collideFrom(first, data, geom, callback);
    else
        collideRegion(data, geom, callback);
    lock_count--;
}

// The members of the space cannot move while it is locked, but the geom may, if it is not one of them: then
// upstream goes on with its new box.
void dxOrderedSpace::collideRegion(void *data, dxGeom *geom, dNearCallback *callback) {
    if (m_index == nullptr) m_index.reset(new dxRegionIndex(m_members));
    const auto depth = static_cast<std::size_t>(lock_count);
    while (m_regions.size() < depth) m_regions.emplace_back();
    std::vector<Slot> &region = m_regions[depth - 1];
    const dxBounds box(geom->aabb);
    m_index->find(m_members, box, region);
    for (const Slot slot : region) {
        dxGeom *const member = m_members[slot].geom;
        if (!dxGeomIsEnabled(member)) continue;
        collideAABBs(member, geom, data, callback);
        const bool hasMoved = (geom->gflags & GEOM_AABB_BAD) != 0 || std::memcmp(geom->aabb, box.v, sizeof box.v) != 0;
        if (hasMoved) return collideFrom(member->next, data, geom, callback);
    }
}
