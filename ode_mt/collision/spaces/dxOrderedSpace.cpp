#include "collision/spaces/dxOrderedSpace.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <optional>
#include <utility>

#include "collision/broadphase/dxAdaptiveBroadphase.h"
#include "collision/pairs/dxMissedNotifications.h"
#include "collision/narrowphase/dxTransformedGeom.h"
#include "collision/pairs/dxPairPrefetch.h"
#include "core/dxNoIndex.h"
#include "core/dxStopwatch.h"
#include "threading/dxInterruptingScope.h"
#include "threading/timeline/dxTimelineSpan.h"

#include "collision_space_internal.h"
#include "util.h"

namespace {

// Geoms that one worker takes at once: some ten microseconds.
constexpr std::size_t kBoxesPerChunk = 128;

// Geoms between asking the memory for one's place and computing its box.
constexpr std::size_t kBoxPrefetchDistance = 4;

// On the timeline.
constexpr dxTimelineEvent kBroadPhase{"broad phase", "collision", {"pairs"}, dxTimelineEvent::Kind::Span, dxFrameStage::BroadPhase};
constexpr dxTimelineEvent kNearCallbacks{"near-callbacks", "collision", {"pairs"}, dxTimelineEvent::Kind::Span, dxFrameStage::NearCallbacks};

// Geoms; with fewer, reading the clock would take longer than it tells.
constexpr int kMinTimed = 24;

// All of the first calls that change pairs are timed but the very first, which takes memory; then one of so many.
constexpr unsigned kCallsTimedFirst = 8, kCallsPerTime = 4;

bool isTimedUpdate(unsigned update) { return (update != 1 && update <= kCallsTimedFirst) || update % kCallsPerTime == 0; }

// A near-callback whose calls are counted, as the pairs of a walk are known by nothing else.
struct CountedCallback {
    void *data;
    dNearCallback *callback;
    std::uint64_t &calls;

    static void call(void *counted, dGeomID geom1, dGeomID geom2) {
        const CountedCallback &self = *static_cast<const CountedCallback *>(counted);
        ++self.calls;
        self.callback(self.data, geom1, geom2);
    }
};

// To clean it, or what is within it, may run a function of the program's.
bool mayRunUserCode(const dxGeom *geom) { return geom->type >= dFirstUserClass || geom->type == dGeomTransformClass || IS_SPACE(geom); }

}  // namespace

// The slot is kept in a field that belongs to the space a geom is in.
dxOrderedSpace::Slot dxOrderedSpace::slotOf(const dxGeom *geom) {
    return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(geom->tome_ex) - 1);
}

dxOrderedSpace *dxOrderedSpace::of(const dxGeom *geom) {
    return geom->tome_ex != nullptr ? from(geom->parent_space) : nullptr;
}

dxOrderedSpace::dxOrderedSpace(dSpaceID parent, int kind, dxPairOrder order) : dxSpace(parent), m_keeping(order) { type = kind; }

// From here on the geoms are in a space of upstream's, whose destructor removes or destroys them.
dxOrderedSpace::~dxOrderedSpace() {
    for (Slot slot = 0; slot < m_members.end(); ++slot)
        if (dxGeom *const geom = m_members.geomIn(slot)) geom->tome_ex = nullptr;
}

// What upstream refuses, it refuses before it has changed anything; but the spaces around this one may be
// locked, and then an assertion fails after the geom is in, or out.
void dxOrderedSpace::add(dxGeom *geom) {
    CHECK_NOT_LOCKED(this);
    dAASSERT(geom);
    dUASSERT(mayCome(geom), "geom is already in a space");
    reserveMemory(m_members.end() + 1);
    const Slot slot = m_members.add(geom);
    m_members.setPresence(slot, dxGeomIsEnabled(geom));
    geom->tome_ex = reinterpret_cast<dxGeom **>(static_cast<std::uintptr_t>(slot) + 1);
    comes(geom, slot);
    if (m_prefetch != nullptr) m_prefetch->forgetGeom(slot);
    dxOrderedSpace *const inner = IS_SPACE(geom) ? from(static_cast<dxSpace *>(geom)) : nullptr;
    if (inner != nullptr && inner->hasStrays()) dxMissedNotifications.add();
    dxSpace::add(geom);
}

bool dxOrderedSpace::mayCome(const dxGeom *geom) const {
    return geom->parent_space == nullptr && geom->next == nullptr;
}

void dxOrderedSpace::remove(dxGeom *geom) {
    CHECK_NOT_LOCKED(this);
    dAASSERT(geom);
    dUASSERT(geom->parent_space == this, "object is not in this space");
    const Slot slot = slotOf(geom);
    goes(geom, slot);
    geom->tome_ex = nullptr;
    m_members.remove(slot);
    m_index.drop(slot);
    dxSpace::remove(geom);
}

void dxOrderedSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    dxTransformedGeom::noticeLeft();
    forgetRunner();
    lock_count++;
    m_isPrefetching = false;
    if (m_prefetch != nullptr) m_prefetch->forgetPair();
    if (isRecorded())
        callBack(makeReadyRecorded(), data, callback);
    else
        callBackUnrecorded(data, callback);
    lock_count--;
}

void dxOrderedSpace::callBackUnrecorded(void *data, dNearCallback *callback) {
    m_isFoundAnew = false;
    if (makeReady())
        deliver(data, callback);
    else
        callBackUnkept(data, callback);
}

bool dxOrderedSpace::makeReadyRecorded() {
    m_isFoundAnew = false;
    dxTimelineSpan span(kBroadPhase, isRecorded(), dxTimelineSpan::Begin::Adjoining);
    const bool isReady = makeReady();
    span.set(0, m_pairs.size());
    return isReady;
}

void dxOrderedSpace::callBack(bool isReady, void *data, dNearCallback *callback) {
    dxTimelineSpan span(kNearCallbacks, isRecorded(), dxTimelineSpan::Begin::Adjoining);
    dxTimelineRing *const ring = span.ring();
    const std::uint64_t before = ring != nullptr ? ring->pairs : 0;
    if (isReady) {
        if (ring != nullptr) ring->pairs += m_pairs.size();
        deliver(data, callback);
    } else if (ring == nullptr) {
        callBackUnkept(data, callback);
    } else {
        CountedCallback counted{data, callback, ring->pairs};
        callBackUnkept(&counted, CountedCallback::call);
    }
    if (ring != nullptr) span.set(0, ring->pairs - before);
}

void dxOrderedSpace::callBackUnkept(void *data, dNearCallback *callback) {
    if (m_isFoundAnew)
        deliverAnew(data, callback);
    else
        walk(data, callback, nullptr);
}

void dxOrderedSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    dAASSERT(geom && callback);
    dxTransformedGeom::noticeLeft();
    lock();
    cleanGeoms();
    geom->recomputeAABB();
    collideWith(data, geom, callback);
    unlock();
}

bool dxOrderedSpace::isWorthWalking(bool isWalked, int moved, std::size_t comparisons) const {
    dxBroadphaseFacts facts;
    facts.order = pairOrder();
    facts.current = isWalked ? dxBroadphaseKind::ListWalk : dxBroadphaseKind::None;
    facts.mayWalk = mayWalk();
    facts.geoms = count;
    facts.moved = moved;
    facts.comparisons = comparisons;
    return dxChooseBroadphase(facts) == dxBroadphaseKind::ListWalk;
}

bool dxOrderedSpace::lookForStrays() {
    const std::unique_lock<std::mutex> alone(m_lookingForStrays, std::try_to_lock);
    if (!alone) return true;
    const std::uint64_t missed = dxMissedNotifications.count();
    for (dxGeom *geom = first; geom != nullptr; geom = geom->next) takeBoxAgain(geom);
    bool hasStrays = hasStrayMembers();
    for (dxGeom *geom = first; geom != nullptr && !hasStrays; geom = geom->next) {
        dxOrderedSpace *const inner = IS_SPACE(geom) ? from(static_cast<dxSpace *>(geom)) : nullptr;
        hasStrays = inner != nullptr && inner->hasStrays();
    }
    m_hasStrays.store(hasStrays, std::memory_order_relaxed);
    m_notificationsMissed.store(missed, std::memory_order_release);
    return true;
}

void dxOrderedSpace::noteStrays() {
    m_hasStrays.store(true, std::memory_order_relaxed);
    if (parent_space != nullptr) dxMissedNotifications.add();
}

bool dxOrderedSpace::hasStrays() {
    mayHaveStrays();
    return !isSureOfMembers();
}

void dxOrderedSpace::filtersChanged(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    m_members.setFilter(slot, dxFilterOf(geom));
    m_members.markChanged(slot);
    ++m_touched;
}

void dxOrderedSpace::enabledChanges(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    m_members.noteSwitch(slot);
    ++m_touched;
    if (isLeftOut(slot)) ++m_comebacks;
}

bool dxOrderedSpace::takeSwitches() {
    if (m_members.switched().empty()) return true;
    if (lock_count > 1) return false;
    for (const Slot slot : m_members.switched())
        if (const dxGeom *const geom = m_members.geomIn(slot)) m_members.setPresence(slot, dxGeomIsEnabled(geom));
    m_members.forgetSwitches();
    return true;
}

void dxOrderedSpace::setBroadphase(std::unique_ptr<dxBroadphase> broadphase) {
    m_broadphase = std::move(broadphase);
    m_keeping = dxPairKeeping(pairOrder());
    startAnew();
}

void dxOrderedSpace::startAnew() {
    m_pairs.clear();
    m_defaultBroadphase.reset();
    m_kept.reset();
    m_members.markAllChanged();
}

bool dxOrderedSpace::collideShared(dxTaskRunner &runner, bool arraysStay, void *data,
                                   dNearCallback *callback) {
    if (!preparePrefetch(runner)) {
        collide(data, callback);
        return false;
    }
    const dxNarrowphasePrefetch::Scope scope(*m_prefetch, runner, arraysStay);
    dxTransformedGeom::noticeLeft();
    lock_count++;
    m_isPrefetching = makeReadyShared(runner);
    callBack(m_isPrefetching, data, callback);
    lock_count--;
    return true;
}

bool dxOrderedSpace::preparePrefetch(const dxTaskRunner &runner) {
    try {
        if (m_prefetch == nullptr) m_prefetch.reset(new dxNarrowphasePrefetch);
        m_prefetch->reserveMemory(runner, m_members.end());
        return true;
    } catch (const std::bad_alloc &) {
        return false;
    }
}

// The runner is given back unless the call is left by a jump. Then it is not in use, and collide() forgets it.
bool dxOrderedSpace::makeReadyShared(dxTaskRunner &runner) {
    struct Borrowed {
        dxOrderedSpace &space;
        ~Borrowed() { space.forgetRunner(); }
    };
    m_lent = m_runner = &runner;
    const Borrowed borrowed{*this};
    return makeReadyRecorded();
}

// Only where all are of the built-in classes whose boxes depend on nothing but themselves, their data and their bodies. A function of the program's
// may change these, or leave, and geoms behind it would have boxes that upstream has not computed.
bool dxOrderedSpace::computeBoxes(const std::vector<dxGeom *> &geoms) {
    if (m_runner == nullptr || geoms.size() < kBoxesPerChunk) return false;
    if (std::any_of(geoms.begin(), geoms.end(), mayRunUserCode)) return false;
    std::atomic<bool> areAll{true};
    m_runner->forChunks(dxParallelStage::Boxes, geoms.size(), kBoxesPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kBoxPrefetchDistance < end) dxPairPrefetch::pose(geoms[i + kBoxPrefetchDistance]);
            try {
                const dxInterruptingScope scope;
                geoms[i]->recomputeAABB();
            } catch (const dxUpstreamInterrupted &) {  // an assertion, which clean() comes to in its turn
                areAll.store(false, std::memory_order_relaxed);
            }
        }
    });
    return areAll.load(std::memory_order_relaxed);
}

void dxOrderedSpace::cleanComputed(const std::vector<dxGeom *> &geoms, dxRank first, std::vector<Slot> &slots) {
    slots.resize(geoms.size());
    m_runner->forChunks(dxParallelStage::Boxes, geoms.size(), kBoxesPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kBoxPrefetchDistance < end) m_members.prefetch(slotOf(geoms[i + kBoxPrefetchDistance]));
            dxGeom *const geom = geoms[i];
            const Slot slot = slotOf(geom);
            geom->gflags &= ~GEOM_DIRTY;
            const bool isPlaced =
                m_members.place(slot, first - static_cast<dxRank>(i), dxBounds(geom->aabb), dxFilterOf(geom), dxGeomIsEnabled(geom));
            slots[i] = isPlaced ? slot : kNoIndex;
        }
    });
    for (std::size_t i = 0; i < geoms.size(); ++i) {
        if (slots[i] == kNoIndex) {
            rank(geoms[i], first - static_cast<dxRank>(i));
        } else {
            m_members.moved(slots[i]);
            m_index.loosen(slots[i], m_members[slots[i]].bounds);
            ++m_touched;
        }
    }
}

void dxOrderedSpace::clean(const std::vector<dxGeom *> &geoms, std::size_t index) {
    if (index + kBoxPrefetchDistance < geoms.size()) dxPairPrefetch::pose(geoms[index + kBoxPrefetchDistance]);
    clean(geoms[index]);
}

void dxOrderedSpace::clean(dxGeom *geom) {
    m_runner = nullptr;  // until findPairs()
    if (IS_SPACE(geom)) static_cast<dxSpace *>(geom)->cleanGeoms();
    geom->recomputeAABB();
    geom->gflags &= ~GEOM_DIRTY;
}

void dxOrderedSpace::rank(dxGeom *geom, dxRank rank, const dxBounds &bounds) {
    const Slot slot = slotOf(geom);
    m_members.setRank(slot, rank);
    m_members.setPresence(slot, dxGeomIsEnabled(geom));  // without a size it counts as disabled
    m_members.setBounds(slot, bounds, dxFilterOf(geom));
    m_members.markChanged(slot);
    m_index.loosen(slot, bounds);
    ++m_touched;
}

bool dxOrderedSpace::makeReady() {
    cleanToCollide();
    return findPairs();
}

bool dxOrderedSpace::findPairs() {
    m_runner = m_lent;
    if (!requireRanks() || !takeSwitches()) return false;
    if (m_members.changed().empty()) return true;
    if (lock_count > 1) return false;  // a call around this one goes through pairs()
    return whereMemorySuffices([this] { return m_keeping.isKept() && mayKeep() ? updatePairs() : findAnew(); });
}

bool dxOrderedSpace::updatePairs() {
    dxPairWork work;
    if (!m_arePairsKept) startAnew();
    work.geoms = static_cast<std::size_t>(count);
    work.comparisons = work.geoms * work.geoms / 2;
    work.changed = m_members.changed().size();
    const bool isTimed = count >= kMinTimed && !isShared() && isTimedUpdate(++m_updates);
    std::optional<dxStopwatch> stopwatch;
    if (isTimed) stopwatch.emplace();
    update(m_pairs, work);
    const double ns = isTimed ? stopwatch->ns() : 0;
    if (isTooMany(m_pairs.size())) m_keeping.overflow();
    if (!m_keeping.isKept()) return findAnew();
    m_arePairsKept = true;
    m_members.forgetChanges();
    m_touched = 0;
    work.pairs = m_pairs.size();
    work.overlaps = std::max(work.found, work.pairs);
    if (hasBroadphase()) return true;  // which is not to be left for another way
    if (isTimed) m_keeping.noteTime(work, ns);
    m_keeping.note(work);
    return true;
}

// With a runner the pairs are wanted beforehand. They are valid until a member changes, but nothing is known of their keys.
bool dxOrderedSpace::findAnew() {
    if (m_arePairsKept) forgetPairs();
    m_isFoundAnew = !isShared() || isTooMany(m_pairsAnew);
    if (m_isFoundAnew) return false;
    dxPairRows &rows = gatherRows();
    m_pairs.clear();
    collectRows(rows, m_pairs);
    m_members.forgetChanges();
    noteAnew(rows, m_pairs.size());
    return true;
}

void dxOrderedSpace::collectRows(dxPairRows &rows, std::vector<dxOrderedPair> &pairs) {
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        const std::size_t found = rows.find(row), before = pairs.size();
        const std::size_t first = rows.first(row);
        pairs.resize(before + found);
        for (std::size_t i = 0; i < found; ++i) {
            const std::size_t second = rows.second(i);
            pairs[before + i] = {rows.geom(first), rows.geom(second), {rows.slot(first), rows.slot(second)}};
        }
    }
}

void dxOrderedSpace::noteAnew(const dxPairRows &rows, std::size_t pairs) {
    dxPairWork work;
    work.comparisons = rows.comparisons();
    work.geoms = rows.geoms();
    work.overlaps = rows.overlaps();
    work.pairs = pairs;
    noteAnew(work);
}

void dxOrderedSpace::noteAnew(dxPairWork work) {
    m_pairsAnew = work.pairs;
    if (m_keeping.isKept()) return;
    work.changed = std::min(std::exchange(m_touched, 0), work.geoms);
    m_keeping.note(work);
}

// Discards partial results. A broad phase that was set must be set again by its owner.
void dxOrderedSpace::giveUpPairs() {
    m_broadphase.reset();
    m_dense.reset();
    m_matches = {};
    startAnew();
}

bool dxOrderedSpace::isTooMany(std::size_t pairs) const {
    return pairs > dxPairLimitOf(pairOrder())(m_members.end());
}

// With their memory.
void dxOrderedSpace::forgetPairs() {
    m_arePairsKept = false;
    startAnew();
    m_pairs = {};
    m_matches = {};
}

void dxOrderedSpace::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    dxBroadphaseFacts facts;
    facts.order = pairOrder();
    facts.geoms = count;
    facts.current = m_dense != nullptr ? dxBroadphaseKind::OrderedTable : dxBroadphaseKind::None;
    const bool dense = m_broadphase == nullptr && dxChooseBroadphase(facts) == dxBroadphaseKind::OrderedTable;
    if (dense != (m_dense != nullptr)) {
        m_dense.reset(dense ? new dxBruteForcePairs : nullptr);
        startAnew();
    }
    if (dense)
        work.found = m_dense->update(m_members, pairs);
    else
        updateSorted(pairs, work);
}

void dxOrderedSpace::updateSorted(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    m_matches.clear();
    findAndPlace(m_matches, pairs);
    work.found = m_matches.size();
}

void dxOrderedSpace::findAndPlace(std::vector<dxBroadphase::Match> &matches,
                                  std::vector<dxOrderedPair> &pairs) {
    if (m_broadphase == nullptr && m_defaultBroadphase == nullptr)
        m_defaultBroadphase.reset(new dxAdaptiveBroadphase(dxPairLimitOf(pairOrder())));
    if (m_kept == nullptr) m_kept.reset(new dxKeptPairs);
    (m_broadphase != nullptr ? m_broadphase : m_defaultBroadphase)->findOverlaps(m_members, runner(), matches);
    if (isTooMany(matches.size())) {
        m_keeping.overflow();
        forgetPairs();
        return;
    }
    m_kept->update(m_members, matches, *this, runner(), pairs);
}

bool dxOrderedSpace::primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const {
    const dxRank rankA = m_members[a].rank, rankB = m_members[b].rank;
    swapped = rankA < rankB;
    word = dxFrontFirst(std::max(rankA, rankB));
    return true;
}

bool dxOrderedSpace::secondaryKey(Slot, Slot second, dxPairKey &key) const {
    key.words[1] = dxFrontFirst(m_members[second].rank);
    key.words[2] = key.words[3] = 0;
    return true;
}

// Upstream tests whether a geom is enabled once before it is paired with those behind it, and each of those at its
// pair. A callback may enable or disable either.
void dxOrderedSpace::deliverInOrder(const std::vector<dxOrderedPair> &pairs, void *data,
                                    dNearCallback *callback) {
    const dxGeom *front = nullptr;
    bool frontIsEnabled = false;
    dxNarrowphasePrefetch *const ahead = this->ahead();
    const std::uint64_t missed = dxMissedNotifications.count(), comebacks = m_comebacks;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const dxOrderedPair &pair = pairs[i];
        if (pair.first != front) {
            front = pair.first;
            frontIsEnabled = dxGeomIsEnabled(front);
        }
        if (!frontIsEnabled || !dxGeomIsEnabled(pair.second)) continue;
        if (ahead != nullptr) ahead->beforePair(pairs, i);
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed && m_comebacks == comebacks) continue;
        const dxOrderedPair last = pair;
        return walk(data, callback, &last);
    }
}

bool dxOrderedSpace::isStill(const dxGeom *geom, const dxBounds &box) {
    return (geom->gflags & GEOM_AABB_BAD) == 0 && std::memcmp(geom->aabb, box.v, sizeof box.v) == 0;
}

// The members of the space cannot move while it is locked.
dxGeom *dxOrderedSpace::collideRegion(void *data, dxGeom *geom, dNearCallback *callback) {
    const dxBounds box(geom->aabb);
    const Region region = beforeCallbacks([&] { return Region(*this, box); });
    const std::uint64_t missed = dxMissedNotifications.count();
    for (const Slot slot : region.slots()) {
        dxGeom *const member = m_members.geomIn(slot);
        if (!dxGeomIsEnabled(member)) continue;
        dxCollideBoxes(member, geom, data, callback);
        if (!isStill(geom, box) || dxMissedNotifications.count() != missed) return member;
    }
    return nullptr;
}
