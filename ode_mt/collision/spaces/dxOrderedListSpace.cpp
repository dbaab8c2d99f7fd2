#include "collision/spaces/dxOrderedListSpace.h"

#include <algorithm>

#include "util.h"

#include "collision/pairs/dxMissedNotifications.h"
#include "core/dxPrefetch.h"
#include "core/dxReserve.h"

namespace {

// Prefetch distance in geoms.
constexpr std::size_t kGeomPrefetchDistance = 8;

bool isDirty(const dxGeom *geom) { return (geom->gflags & GEOM_DIRTY) != 0; }

dxGeom *firstClean(dxGeom *geom) {
    while (geom != nullptr && isDirty(geom)) geom = geom->next;
    return geom;
}

// For a thread that may not clean. Others may be doing the same.
void computeBadBoxes(dxGeom *geom) {
    for (; geom != nullptr; geom = geom->next) {
        if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
        geom->recomputeAABB();
    }
}

// As upstream's collide2. Returns how many it has met.
std::size_t collideFrom(dxGeom *member, void *data, dxGeom *geom, dNearCallback *callback) {
    dxGeomQuery query(data, geom, callback);
    for (; member != nullptr; member = member->next) query.meet(member);
    return query.met();
}

}  // namespace

// Cleaning would change nothing: several threads may ask so at the same time.
bool dxOrderedListSpace::isAtRest() const {
    if (!isClean() || !isSureOfMembers()) return false;
    return m_walking ? mayWalk() : !m_isIrregular && members().unranked() == 0;
}

// Upstream stops at the first geom that is clean, and so do we. Ranks are given from the front downwards, at
// once, because a user's bounding-box function may leave by an exception or a jump.
void dxOrderedListSpace::cleanGeoms() {
    if (isAtRest()) return;
    if (__libc_single_threaded != 0 && isWalkedOnly()) {
        lock_count++;
        cleanWalked();
        lock_count--;
        return;
    }
    const dxSoleCleaner::Scope cleaner(m_cleaner);
    lock();
    if (!cleaner.isMine())
        computeBadBoxes(first);
    else if (!isAtRest())  // by now
        cleanAlone();
    unlock();
}

void dxOrderedListSpace::cleanToCollide() {
    m_walking.noteCollided();
    m_cleaner.dismiss();
    if (isAtRest()) return;
    lock_count++;
    if (isWalkedOnly())
        cleanWalked();
    else
        cleanAlone();
    lock_count--;
}

void dxOrderedListSpace::cleanWalked() {
    m_isInterrupted = true;
    ++m_cleanings;
    m_walking.noteMoved(cleanFrom(first), count);
    m_isInterrupted = false;
}

void dxOrderedListSpace::cleanAlone() {
    m_isIrregular = mayHaveStrays() || m_isInterrupted || m_isIrregular;
    m_isInterrupted = true;
    const std::uint64_t missed = dxMissedNotifications.count();
    gatherDirty();
    chooseToWalk();
    cleanDirty();
    if (dxMissedNotifications.count() != missed) rankAll();
    m_isInterrupted = false;
}

void dxOrderedListSpace::cleanDirty() {
    const std::uint64_t cleaning = ++m_cleanings;
    const bool givesRanks = !m_walking;
    dxRank next = givesRanks ? members().firstOf(count) : 0;
    const bool areComputed = givesRanks && computeBoxes(m_dirty);
    if (areComputed) {
        cleanComputed(m_dirty, next, m_dirtySlots);
        next -= static_cast<dxRank>(m_dirty.size());
    }
    for (std::size_t i = areComputed ? m_dirty.size() : 0; i < m_dirty.size(); ++i) {
        dxGeom *const geom = m_dirty[i];
        if (givesRanks && i + kGeomPrefetchDistance < m_dirty.size())
            members().prefetch(slotOf(m_dirty[i + kGeomPrefetchDistance]));
        clean(m_dirty, i);
        if (m_cleanings != cleaning) return cleanBehind(geom);
        if (givesRanks) rank(geom, next--);
    }
    dxGeom *const behind = m_dirty.empty() ? first : m_dirty.back()->next;
    if (behind != nullptr && isDirty(behind)) return cleanBehind(m_dirty.back());
    if (givesRanks && (members().unranked() != 0 || m_isIrregular)) rankBehindClean(behind, next);
}

// Up to the first that is clean. Returns how many.
int dxOrderedListSpace::cleanFrom(dxGeom *geom) {
    int cleaned = 0;
    for (; geom != nullptr && isDirty(geom); geom = geom->next, ++cleaned) clean(geom);
    return cleaned;
}

// The bounding-box function of this geom has had the space cleaned: what was gathered is gone, and ranks were
// given by both. Or one has made a stray of the geom behind those that were gathered, which upstream then
// cleans.
void dxOrderedListSpace::cleanBehind(dxGeom *geom) {
    cleanFrom(geom->next);
    rankAll();
}

// A bounding-box function has changed what was gathered, or made a stray.
void dxOrderedListSpace::rankAll() {
    m_isIrregular = true;
    if (!m_walking) rankBehindClean(first, members().firstOf(count));
}

void dxOrderedListSpace::chooseToWalk() {
    const auto moved = static_cast<int>(m_dirty.size());
    m_walking.noteMoved(moved, count);
    m_walking.set(isWorthWalking(m_walking, moved) || (m_walking.isForQuery(moved, count) && mayWalk()));
    m_isIrregular = m_isIrregular || m_walking;
}

// The vectorised walk uses the current enabled flags.
bool dxOrderedListSpace::isLeftOut(Slot slot) const {
    return m_walking ? !dxGeomIsEnabled(members().geomIn(slot)) : dxOrderedSpace::isLeftOut(slot);
}

// Until many move again.
void dxOrderedListSpace::stopWalking() {
    rankBehindClean(first, members().firstOf(count));
    m_walking.set(false);
}

bool dxOrderedListSpace::requireRanks() {
    const int moved = m_walking.takeMoved();
    if (m_walking && m_walking.hasRested(moved, minMovedToWalk())) stopWalking();
    return ranksStand();
}

// The geoms mostly come in the order of the last call, whose list tells what will be read. What a geom that is gone had is prefetched in
// vain.
void dxOrderedListSpace::gatherDirty() {
    std::size_t gathered = 0;
    for (dxGeom *geom = first; geom != nullptr && isDirty(geom); geom = geom->next, ++gathered) {
        if (gathered + kGeomPrefetchDistance < m_dirty.size()) {
            const dxGeom *const expected = m_dirty[gathered + kGeomPrefetchDistance];
            dxPrefetch::line(&expected->gflags);
            dxPrefetch::line(&expected->next);
        }
        if (gathered < m_dirty.size())
            m_dirty[gathered] = geom;
        else
            m_dirty.push_back(geom);
    }
    m_dirty.resize(gathered);
}

void dxOrderedListSpace::reserveMemory(Slot slots) {
    dxReserveCapacity(m_dirty, slots);
    dxReserveCapacity(m_dirtySlots, slots);
}

// Upstream puts a clean one in front, too. Those behind it that have changed are then cleaned no more.
void dxOrderedListSpace::comes(dxGeom *geom, Slot /*slot*/) {
    if (!isDirty(geom) && first != nullptr && isDirty(first)) noteStrays();
}

bool dxOrderedListSpace::hasStrayMembers() const {
    for (const dxGeom *geom = firstClean(first); geom != nullptr; geom = geom->next)
        if (isDirty(geom)) return true;
    return false;
}

// A dirty geom may be behind a clean one: the clean one was added clean, or the other is stray. Upstream never gets to
// those that are dirty: they keep the boxes that they have, and an assertion fails where one meets whose box is not up
// to date. While there are such geoms, all ranks are assigned again.
void dxOrderedListSpace::rankBehindClean(dxGeom *geom, dxRank next) {
    const bool wasIrregular = m_isIrregular;
    bool isIrregular = false;
    m_hasBadBox = false;
    for (; geom != nullptr && (wasIrregular || members().unranked() != 0 || isDirty(geom));
         geom = geom->next) {
        isIrregular = isIrregular || isDirty(geom);
        m_hasBadBox = m_hasBadBox || (geom->gflags & GEOM_AABB_BAD) != 0;
        rank(geom, next--);
    }
    m_isIrregular = isIrregular;
}

// As upstream, whatever is known of the members; unless another thread is cleaning them.
void dxOrderedListSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    if (isWorthAnIndex() || !isClean()) return dxOrderedSpace::collide2(data, geom, callback);
    collideClean(geom, callback, [&] { noteMet(collideFrom(first, data, geom, callback)); });
}

void dxOrderedListSpace::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    if (m_walking && isWorthAnIndex()) m_walking.query([this] { stopWalking(); });
    if (!isWorthAnIndex() || !isAtRest() || !ranksStand())
        noteMet(collideFrom(first, data, geom, callback));
    else if (const dxGeom *const last = collideRegion(data, geom, callback))
        collideFrom(last->next, data, geom, callback);
}
