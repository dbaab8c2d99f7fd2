#include "collision/spaces/dxListCleaner.h"

#include "collision/spaces/dxGeomQuery.h"
#include "collision/spaces/dxWalking.h"
#include "core/dxPrefetch.h"
#include "core/dxReserve.h"
#include "threading/dxSchedulePoints.h"

namespace {

// Prefetch distance, in geoms.
constexpr std::size_t kGeomPrefetchDistance = 8;

bool isDirty(const dxGeom *geom) { return (geom->gflags & GEOM_DIRTY) != 0; }

dxGeom *firstClean(dxGeom *geom) {
    while (geom != nullptr && isDirty(geom)) geom = geom->next;
    return geom;
}

// Does what a thread can do that is not the cleaner. Several threads may do this at the same time.
void computeBadBoxes(dxGeom *geom) {
    for (; geom != nullptr; geom = geom->next) {
        if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
        geom->recomputeAABB();
    }
}

// Executes upstream's collide2 from a member on. Returns the number of members met.
std::size_t collideFrom(dxGeom *member, void *data, dxGeom *geom, dNearCallback *callback) {
    dxGeomQuery query(data, geom, callback);
    for (; member != nullptr; member = member->next) query.meet(member);
    return query.met();
}

}  // namespace

bool dxListCleaner::isAtRest() const {
    if (!isClean() || !m_geoms.isSure()) return false;
    return m_geoms.walking() ? m_geoms.mayWalk() : !m_isIrregular && m_geoms.members().unranked() == 0;
}

// Returns false if another thread is the cleaner and remains it.
bool dxListCleaner::becomeCleaner() {
    const std::thread::id self = std::this_thread::get_id();
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        std::thread::id cleaner;
        dxPerturb(dxSchedulePoint::ClaimCleaning);
        if (m_cleaningThread.compare_exchange_weak(cleaner, self, std::memory_order_acq_rel) || cleaner == self) return true;
        dxPerturb(dxSchedulePoint::AwaitCleaning);
        std::this_thread::yield();
    }
    return false;
}

// As upstream, stops at the first clean geom. Each geom gets its rank as soon as it is clean, because a user's bounding-box function may leave by an
// exception or a jump.
void dxListCleaner::clean() {
    if (isAtRest()) return;
    if (__libc_single_threaded != 0 && isWalkedOnly()) {
        m_geoms.space().lock_count++;
        cleanWalked();
        m_geoms.space().lock_count--;
        return;
    }
    struct Cleaner {
        dxListCleaner &list;
        const bool isMine;
        ~Cleaner() {
            if (isMine) list.dismissCleaner();
        }
    };
    const Cleaner cleaner{*this, becomeCleaner()};
    m_geoms.lock();
    if (!cleaner.isMine)
        computeBadBoxes(first());
    else if (!isAtRest())  // it may be by now
        cleanAlone();
    m_geoms.unlock();
}

bool dxListCleaner::cleanToCollide() {
    dxWalking &walking = m_geoms.walking();
    walking.noteCollided();
    dismissCleaner();
    if (!isAtRest()) {
        m_geoms.space().lock_count++;
        if (isWalkedOnly())
            cleanWalked();
        else
            cleanAlone();
        m_geoms.space().lock_count--;
    }
    const int moved = walking.takeMoved();
    if (walking && walking.hasRested(moved, minMovedToWalk())) stopWalking();
    return areRanksValid();
}

void dxListCleaner::cleanWalked() {
    m_isInterrupted = true;
    ++m_cleanings;
    m_geoms.walking().noteMoved(cleanFrom(first()), m_geoms.count());
    m_isInterrupted = false;
}

void dxListCleaner::cleanAlone() {
    m_isIrregular = m_geoms.mayHaveStaleGeoms() || m_isInterrupted || m_isIrregular;
    m_isInterrupted = true;
    const std::uint64_t missed = dxMissedNotifications.count();
    gatherDirty();
    chooseToWalk();
    cleanDirty();
    if (dxMissedNotifications.count() != missed) rankAll();
    m_isInterrupted = false;
}

void dxListCleaner::cleanDirty() {
    const std::uint64_t cleaning = ++m_cleanings;
    const bool assignsRanks = !m_geoms.walking();
    dxRank next = assignsRanks ? m_geoms.members().firstOf(m_geoms.count()) : 0;
    const bool areComputed = assignsRanks && m_geoms.computeBoxes(m_dirty);
    if (areComputed) {
        m_geoms.cleanComputed(m_dirty, next, m_dirtySlots);
        next -= static_cast<dxRank>(m_dirty.size());
    }
    for (std::size_t i = areComputed ? m_dirty.size() : 0; i < m_dirty.size(); ++i) {
        dxGeom *const geom = m_dirty[i];
        if (assignsRanks && i + kGeomPrefetchDistance < m_dirty.size())
            m_geoms.members().prefetch(dxSpaceGeoms::slotOf(m_dirty[i + kGeomPrefetchDistance]));
        m_geoms.clean(m_dirty, i);
        if (m_cleanings != cleaning) return cleanBehind(geom);
        if (assignsRanks) m_geoms.rank(geom, next--);
    }
    dxGeom *const behind = m_dirty.empty() ? first() : m_dirty.back()->next;
    if (behind != nullptr && isDirty(behind)) return cleanBehind(m_dirty.back());
    if (assignsRanks && (m_geoms.members().unranked() != 0 || m_isIrregular)) rankBehindClean(behind, next);
}

// Cleans up to the first clean geom. Returns the number of geoms.
int dxListCleaner::cleanFrom(dxGeom *geom) {
    int cleaned = 0;
    for (; geom != nullptr && isDirty(geom); geom = geom->next, ++cleaned) m_geoms.clean(geom);
    return cleaned;
}

// Called if the bounding-box function of this geom has had the space cleaned, which gathered other geoms and assigned ranks; or if a function has
// made the geom stale that is behind the gathered ones, which upstream then cleans, too.
void dxListCleaner::cleanBehind(dxGeom *geom) {
    cleanFrom(geom->next);
    rankAll();
}

// Called if a bounding-box function has changed what was gathered, or has made a geom stale.
void dxListCleaner::rankAll() {
    m_isIrregular = true;
    if (!m_geoms.walking()) rankBehindClean(first(), m_geoms.members().firstOf(m_geoms.count()));
}

void dxListCleaner::chooseToWalk() {
    const auto moved = static_cast<int>(m_dirty.size());
    m_geoms.walking().noteMoved(moved, m_geoms.count());
    m_geoms.walking().set(m_geoms.isWorthWalking(moved) || (m_geoms.walking().isForQuery(moved, m_geoms.count()) && m_geoms.mayWalk()));
    m_isIrregular = m_isIrregular || m_geoms.walking();
}

void dxListCleaner::stopWalking() {
    rankBehindClean(first(), m_geoms.members().firstOf(m_geoms.count()));
    m_geoms.walking().set(false);
}

// Geoms are mostly in the order of the last call, so its list tells which memory will be read. Some of those geoms may have been destroyed; a
// prefetch of their memory does no harm.
void dxListCleaner::gatherDirty() {
    std::size_t gathered = 0;
    for (dxGeom *geom = first(); geom != nullptr && isDirty(geom); geom = geom->next, ++gathered) {
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

void dxListCleaner::reserveMemory(Slot slots) {
    dxReserveCapacity(m_dirty, slots);
    dxReserveCapacity(m_dirtySlots, slots);
}

// Upstream puts a clean geom in front, too. Then it no longer cleans the dirty geoms behind it.
void dxListCleaner::onAdded(dxGeom *geom, Slot /*slot*/) {
    if (!isDirty(geom) && first() != nullptr && isDirty(first())) m_geoms.noteStaleGeoms();
}

bool dxListCleaner::readAgain() {
    m_geoms.rankAgain();
    for (const dxGeom *geom = firstClean(first()); geom != nullptr; geom = geom->next)
        if (isDirty(geom)) return true;
    return false;
}

// A dirty geom is behind a clean one if the clean one was added clean, or if the dirty one is stale. Upstream does not clean it: it keeps its box,
// and if that is not up to date an assertion fails at its first pair. While there are such geoms, all ranks are assigned again.
void dxListCleaner::rankBehindClean(dxGeom *geom, dxRank next) {
    const bool wasIrregular = m_isIrregular;
    bool isIrregular = false;
    m_hasBadBox = false;
    for (; geom != nullptr && (wasIrregular || m_geoms.members().unranked() != 0 || isDirty(geom));
         geom = geom->next) {
        isIrregular = isIrregular || isDirty(geom);
        m_hasBadBox = m_hasBadBox || (geom->gflags & GEOM_AABB_BAD) != 0;
        m_geoms.rank(geom, next--);
    }
    m_isIrregular = isIrregular;
}

bool dxListQuery::collideAll(dxSpaceGeoms &geoms, const dxListCleaner &cleaner, void *data, dxGeom *geom, dNearCallback *callback) {
    if (geoms.isWorthAnIndex() || !cleaner.isClean()) return false;
    dxCollideClean(geoms, geom, callback, [&] { geoms.noteMet(collideFrom(geoms.space().first, data, geom, callback)); });
    return true;
}

void dxListQuery::collideWith(dxSpaceGeoms &geoms, dxListCleaner &cleaner, void *data, dxGeom *geom, dNearCallback *callback) {
    if (geoms.walking() && geoms.isWorthAnIndex()) geoms.walking().query([&] { cleaner.stopWalking(); });
    if (!geoms.isWorthAnIndex() || !cleaner.isAtRest() || !cleaner.areRanksValid())
        geoms.noteMet(collideFrom(geoms.space().first, data, geom, callback));
    else if (const dxGeom *const last = dxCollideRegion(geoms, data, geom, callback))
        collideFrom(last->next, data, geom, callback);
}
