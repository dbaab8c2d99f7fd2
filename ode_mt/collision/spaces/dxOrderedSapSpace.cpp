#include "collision/spaces/dxOrderedSapSpace.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/pairs/dxMissedNotifications.h"
#include "collision/pairs/dxPairPrefetch.h"
#include "collision_space_internal.h"
#include "core/dxPrefetch.h"
#include "core/dxReserve.h"
#include "util.h"

namespace {

// Items between asking the memory for one and looking at it.
constexpr std::size_t kPrefetchDistance = 8;

// Geoms that are cleaned before their boxes are taken.
constexpr std::size_t kBoxesAtOnce = 8;

// More pairs of a walk are not left in memory.
constexpr std::size_t kMaxPairsPerGeomKept = 2 * dxBroadphaseThresholds::kMaxComparisonsWalked;

// Of the first of the clean members. Ranks fall from there on.
constexpr dxRank kFirstRank = dxRank{1} << 40;

dxRank rankAt(std::size_t place) { return kFirstRank - place; }

}  // namespace

dxOrderedSapSpace::dxOrderedSapSpace(dSpaceID parent, int axes)
    : dxOrderedSpace(parent, dSweepAndPruneSpaceClass, dxPairOrder::Axis), m_axes(axes), m_sweep(m_axes) {
    dInfiniteAABB(this, aabb);
}

// Geoms go from the front of the two lists, as upstream's do, whatever a geom's destructor of the user's
// moves, adds or destroys on the way. What that has made dirty behind the first list is left to the
// destructors below.
dxOrderedSapSpace::~dxOrderedSapSpace() {
    dxSapWalk::requireUnlocked(*this);
    const auto empty = [this](const std::vector<dxSapLists::Entry> &list) {
        while (!list.empty()) {
            if (cleanup)
                dGeomDestroy(list.front().geom);
            else
                remove(list.front().geom);
        }
    };
    empty(m_lists.dirty());
    empty(m_lists.clean());
}

dxGeom *dxOrderedSapSpace::getGeom(int i) {
    dUASSERT(i >= 0 && i < count, "index out of range");
    const auto at = static_cast<std::size_t>(i), dirtyOnes = m_lists.dirty().size();
    return at < dirtyOnes ? m_lists.dirty()[at].geom : m_lists.clean()[at - dirtyOnes].geom;
}

bool dxOrderedSapSpace::mayCome(const dxGeom *geom) const {
    return geom->tome_ex == nullptr && geom->next_ex == nullptr && dxOrderedSpace::mayCome(geom);
}

void dxOrderedSapSpace::reserveMemory(Slot slots) {
    m_lists.reserveMemory(slots);
    dxReserveCapacity(m_states, slots);
    dxReserveCapacity(m_toClean, slots);
}

void dxOrderedSapSpace::comes(dxGeom *geom, Slot slot) {
    m_lists.add(slot, geom);
    if (slot >= m_states.size()) m_states.resize(slot + 1);
    m_states[slot].part = Part::absent;
    m_isSweepCurrent = false;
}

void dxOrderedSapSpace::goes(dxGeom * /*geom*/, Slot slot) {
    const bool wasDirty = m_lists.isDirty(slot);
    const std::size_t place = m_lists.placeOf(slot);
    m_lists.remove(slot);
    if (!wasDirty) rankSuccessor(slot, place);
    m_states[slot].part = Part::absent;
    m_isSweepCurrent = false;
}

void dxOrderedSapSpace::enabledChanges(dxGeom *geom) {
    m_isSweepCurrent = false;
    dxOrderedSpace::enabledChanges(geom);
}

// The member that has taken the place of this one. If this one is absent, no other notification shows that the order
// has changed.
void dxOrderedSapSpace::rankSuccessor(Slot slot, std::size_t place) {
    if (m_walking || place >= m_lists.clean().size()) return;
    const Slot successor = m_lists.clean()[place].slot;
    members().setRank(successor, rankAt(place));
    if (!members().isPresent(slot)) members().markChanged(successor);
}

void dxOrderedSapSpace::dirty(dxGeom *geom) {
    const Slot slot = slotOf(geom);
    if (m_lists.isDirty(slot)) return;
    const std::size_t place = m_lists.placeOf(slot);
    m_lists.makeDirty(slot);
    rankSuccessor(slot, place);
}

// Where a bounding-box function has the space cleaned, or leaves its cleaning, upstream enters geoms twice, and its next collide() fails.
void dxOrderedSapSpace::cleanGeoms() {
    if (m_lists.dirty().empty()) return;
    m_isSweepCurrent = false;
    lock_count++;
    m_toClean.clear();
    for (const dxSapLists::Entry &entry : m_lists.dirty()) m_toClean.push_back(entry.geom);
    const bool wasMessedUp = std::exchange(m_isMessedUp, true);  // where this is left, or nested
    m_walking.noteMoved(static_cast<int>(m_toClean.size()), count);
    if (m_walking.isForQuery(static_cast<int>(m_toClean.size()), count) && mayWalk()) m_walking.set(true);
    if (m_walking)
        for (std::size_t i = 0; i < m_toClean.size(); ++i) clean(m_toClean, i);
    else
        cleanAndRank();
    m_isMessedUp = wasMessedUp || m_lists.dirty().empty();
    m_lists.cleanAll();
    lock_count--;
}

// A box is read some geoms later than it is computed: at once its loads would wait for the stores, which are narrower.
void dxOrderedSapSpace::cleanAndRank() {
    computeBoxes(m_toClean);
    const std::size_t cleanOnes = m_lists.clean().size();
    std::size_t taken = 0;
    const auto takeUpTo = [&](std::size_t end) {
        for (; taken < std::min(end, m_toClean.size()); ++taken) takeBox(m_toClean[taken], rankAt(cleanOnes + taken));
    };
    for (std::size_t i = 0; i < m_toClean.size(); ++i) {
        clean(m_toClean, i);
        if ((i + 1) % kBoxesAtOnce == 0) takeUpTo(i + 1 - kBoxesAtOnce / 2);
    }
    takeUpTo(m_toClean.size());
}

void dxOrderedSapSpace::takeBox(dxGeom *geom, dxRank itsRank) {
    const dxSapBox box = m_axes.boxOf(geom);
    m_states[slotOf(geom)].box = box;
    rank(geom, itsRank, boundsOf(geom, box));
}

void dxOrderedSapSpace::takeBoxAgain(dxGeom *geom) {
    m_isSweepCurrent = false;
    takeBox(geom, members()[slotOf(geom)].rank);
}

bool dxOrderedSapSpace::hasStrayMembers() const {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    return std::any_of(list.begin(), list.end(), [](const dxSapLists::Entry &entry) {
        return (entry.geom->gflags & GEOM_DIRTY) != 0;
    });
}

// The bounds contain the rounded box, and are not inverted, so that all pairs of upstream overlap.
dxBounds dxOrderedSapSpace::boundsOf(const dxGeom *geom, const dxSapBox &box) const {
    dxBounds bounds(geom->aabb);
    if (!m_axes.areAll()) return bounds;
    dReal &low = bounds.v[2 * m_axes.first()], &high = bounds.v[2 * m_axes.first() + 1];
    if (box.low < low) low = box.low;
    if (box.high > high) high = box.high;
    if (box.low > high) high = box.low;
    return bounds;
}

// Not of use: NaN among the keys, along which upstream's sweep loses its way; a box that is not up to date,
// at which it fails an assertion; and a change that a callback made and the call it makes now would see,
// while the call around it has not done with pairs().
bool dxOrderedSapSpace::makeReady() {
    m_walking.noteCollided();
    if (lock_count == 1) {
        m_temporary.restart();
        m_isSweepDelivered = false;
        chooseToWalk();
    }
    cleanGeoms();
    if (lock_count == 1) m_walking.takeMoved();  // has been chosen by
    if (m_isMessedUp) dDebug(d_ERR_UASSERT, "geom counts messed up in %s()", "collide");
    mayHaveStrays();  // a stray has the box of its last query, which is used again
    if ((!isSureOfMembers() && hasUncleanBox()) || !takeSwitches() || m_walking) return false;
    if (m_hasWalked && lock_count == 1) {  // the sort continues the history of the walk's: equal keys may have another order
        m_hasWalked = false;
        startAnew();
    }
    if (members().changed().empty()) return true;
    if (lock_count > 1) return false;
    const bool areTaken = whereMemorySuffices([this] {
        takeParts();
        return true;
    });
    return areTaken && !m_hasNaN && dxOrderedSpace::makeReady();
}

void dxOrderedSapSpace::chooseToWalk() {
    const int moved = std::min(m_walking.takeMoved() + static_cast<int>(m_lists.dirty().size()), count);
    const bool hasRested = m_walking && !isServedBySweep(moved) && m_walking.hasRested(moved, dxMinMovedToWalk(pairOrder(), count));
    const bool isWalked = !hasRested && isWorthWalking(m_walking, moved, m_comparisons);
    if (m_walking && !isWalked) {
        stopWalking();
        m_isSweepCurrent = false;
        m_sweep = dxSapWalk(m_axes);
    }
    m_walking.set(isWalked);
}

// Nothing is faster for a small space at rest, whose geoms may move again, than the pairs of its last walk.
bool dxOrderedSapSpace::isServedBySweep(int moved) const {
    return moved == 0 && m_isSweepCurrent && m_sweep.areMostWanted() && count <= dxBroadphaseThresholds::kMaxAlwaysSwept;
}

// The members that are dirty get ranks when they are cleaned.
void dxOrderedSapSpace::stopWalking() {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t place = 0; place < list.size(); ++place) takeBox(list[place].geom, rankAt(place));
    m_walking.set(false);
}

bool dxOrderedSapSpace::hasUncleanBox() const {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + kPrefetchDistance < list.size()) dxPrefetch::line(&list[i + kPrefetchDistance].geom->gflags);
        if (dxGeomIsEnabled(list[i].geom) && (list[i].geom->gflags & GEOM_AABB_BAD) != 0) return true;
    }
    return false;
}

void dxOrderedSapSpace::takeParts() {
    m_swept.clear();
    m_infinite.clear();
    m_keys.clear();
    m_hasNaN = m_isSorted = false;
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + kPrefetchDistance < list.size()) dxPrefetch::line(&m_states[list[i + kPrefetchDistance].slot]);
        const Slot slot = list[i].slot;
        State &state = m_states[slot];
        if (!m_axes.areAll()) state.box = m_axes.boxOf(list[i].geom);  // a geom's bits may be bounds
        state.part = !members().isPresent(slot) ? Part::absent : state.box.isInfinite ? Part::infinite : Part::swept;
        if (state.part == Part::infinite) m_infinite.push_back(slot);
        if (state.part != Part::swept) continue;
        m_swept.push_back(slot);
        m_keys.push_back(state.box.low);
        m_hasNaN = m_hasNaN || std::isnan(state.box.low);
        // It meets what begins with it if it comes later, not if it comes earlier: which of the two may
        // change with others.
        if (!(state.box.low <= state.box.high)) members().markChanged(slot);
    }
}

// The place of a pair depends on all sorted members: kept pairs get new places.
void dxOrderedSapSpace::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    sortSwept();
    m_again.clear();
    for (std::size_t i = 0; i < std::min(m_sweptPairs, pairs.size()); ++i) {
        const Slot a = pairs[i].slots[0], b = pairs[i].slots[1];
        if (!members().isChanged(a) && !members().isChanged(b)) m_again.push_back({a, b});
    }
    pairs.clear();
    findAndPlace(m_again, pairs);
    work.found = m_again.size();
    work.comparisons = m_comparisons;
    m_sweptPairs = pairs.size();
    pairInfinite(pairs);
}

dxPairRows &dxOrderedSapSpace::gatherRows() {
    sortSwept();
    m_rows.clear(m_inOrder.size());
    for (const Slot slot : m_inOrder) {
        const dxMembers::Member &member = members()[slot];
        m_rows.pushSwept(member.geom, slot, member.filter, m_states[slot].box);
    }
    for (const Slot slot : m_infinite) m_rows.pushInfinite(members()[slot].geom, slot, members()[slot].filter);
    m_places.clear();
    if (!m_infinite.empty())
        for (const Slot slot : m_swept) m_places.push_back(m_states[slot].position);
    m_rows.finish(m_places);
    return m_rows;
}

// As deliver().
void dxOrderedSapSpace::deliverAnew(void *data, dNearCallback *callback) {
    beforeCallbacks([this] { gatherRows(); });
    const std::uint64_t missed = dxMissedNotifications.count();
    const unsigned fills = m_temporary.fills();
    forPairsOf(m_rows, [](const dxGeom *) { return true; }, [&](const dxOrderedPair &pair) {
        dxSapWalk::requireCleanBoxes(pair.first, pair.second);
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed && m_temporary.fills() == fills) return true;
        deliverBehind(pair, fills, data, callback);
        return false;
    });
    m_comparisons = m_rows.comparisons();
}

// Once in the same calls as upstream, for the sake of the sort's state.
void dxOrderedSapSpace::sortSwept() {
    if (std::exchange(m_isSorted, true)) return;
    m_inOrder.clear();
    if (m_swept.empty()) return;
    for (const std::uint32_t index : m_sort.sort(m_keys)) {
        m_states[m_swept[index]].position = static_cast<std::uint32_t>(m_inOrder.size());
        m_inOrder.push_back(m_swept[index]);
    }
}

bool dxOrderedSapSpace::primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const {
    const State &stateA = m_states[a], &stateB = m_states[b];
    if (stateA.part != Part::swept || stateB.part != Part::swept) return false;
    swapped = stateB.position < stateA.position;
    const State &earlier = swapped ? stateB : stateA, &later = swapped ? stateA : stateB;
    word = earlier.position;
    return earlier.box.meets(later.box);
}

bool dxOrderedSapSpace::secondaryKey(Slot, Slot second, dxPairKey &key) const {
    key.words[1] = m_states[second].position;
    key.words[2] = key.words[3] = 0;
    return true;
}

void dxOrderedSapSpace::prefetch(Slot slot) const {
    members().prefetch(slot);
    dxPrefetch::line(&m_states[slot]);
}

void dxOrderedSapSpace::pairInfinite(std::vector<dxOrderedPair> &pairs) const {
    for (std::size_t i = 0; i < m_infinite.size(); ++i) {
        for (std::size_t j = i + 1; j < m_infinite.size(); ++j)
            pairIfMayMeet(m_infinite[i], m_infinite[j], pairs);
        for (const Slot slot : m_swept) pairIfMayMeet(m_infinite[i], slot, pairs);
    }
}

void dxOrderedSapSpace::pairIfMayMeet(Slot a, Slot b, std::vector<dxOrderedPair> &pairs) const {
    const dxMembers::Member &memberA = members()[a], &memberB = members()[b];
    if (dxFiltersAgree(memberA.filter, memberB.filter)) pairs.push_back({memberA.geom, memberB.geom, {a, b}});
}

void dxOrderedSapSpace::deliver(void *data, dNearCallback *callback) {
    dxNarrowphasePrefetch *const ahead = this->ahead();
    const std::uint64_t missed = dxMissedNotifications.count();
    const unsigned fills = m_temporary.fills();
    for (std::size_t i = 0; i < pairs().size(); ++i) {
        if (ahead != nullptr) ahead->beforePair(pairs(), i);
        dxPairPrefetch::forCallback(pairs(), i);
        dxSapWalk::requireCleanBoxes(pairs()[i].first, pairs()[i].second);
        dxDeliver(pairs()[i], data, callback);
        if (dxMissedNotifications.count() == missed && m_temporary.fills() == fills) continue;
        const dxOrderedPair last = pairs()[i];
        return deliverBehind(last, fills, data, callback);
    }
}

// Upstream's pairs from the one behind this on, with those that bits or bodies exclude: an assertion in a callback may have left a geom whose box is
// not up to date, for which the next one fails; or a call within this one has filled the lists anew.
void dxOrderedSapSpace::deliverBehind(const dxOrderedPair &after, unsigned fills, void *data, dNearCallback *callback) {
    dxSapWalk rest(m_axes);
    rest.begin(m_swept.size());
    std::vector<std::uint32_t> places(m_states.size()), order;
    for (std::size_t i = 0; i < m_swept.size(); ++i) {
        const Slot slot = m_swept[i];
        places[slot] = static_cast<std::uint32_t>(i);
        rest.add(members().geomIn(slot), m_states[slot].box);
    }
    for (const Slot slot : m_infinite) rest.addInfinite(members().geomIn(slot));
    for (const Slot slot : m_inOrder) order.push_back(places[slot]);
    rest.findPairs(order);
    rest.deliver(data, callback, m_temporary, fills, &after);
}

// Upstream goes through a list of pairs, as deliver() does.
void dxOrderedSapSpace::walk(void *data, dNearCallback *callback, const dxOrderedPair * /*after*/) {
    m_hasWalked = true;
    const bool isOutermost = m_walking && lock_count == 1;
    m_isSweepDelivered = m_isSweepDelivered || isOutermost;
    if (isOutermost && m_isSweepCurrent && isSureOfMembers()) return m_sweep.deliver(data, callback, m_temporary, m_temporary.fills());
    dxSapWalk once(m_axes);
    dxSapWalk &sweep = isOutermost ? m_sweep : once;
    findPairsOf(sweep);
    m_comparisons = sweep.comparisons();
    if (isOutermost) m_isSweepCurrent = sweep.isRepeatable() && m_axes.areAll();  // or else a geom's bits may be bounds
    if (!isOutermost) fillTemporary(once);
    sweep.deliver(data, callback, m_temporary, m_temporary.fills());
    if (!isOutermost || sweep.pairs() <= kMaxPairsPerGeomKept * static_cast<std::size_t>(count)) return;
    m_isSweepCurrent = false;
    m_sweep = dxSapWalk(m_axes);
}

// Of a call within another one, or of one whose walk is not kept.
void dxOrderedSapSpace::fillTemporary(const dxSapWalk &walk) {
    beforeCallbacks([&] {
        if (lock_count > 1 && m_temporary.isFirst())
            m_isSweepDelivered ? m_temporary.fill(m_sweep.swept(), m_sweep.infinite()) : m_temporary.fill(geomsIn(m_swept), geomsIn(m_infinite));
        m_temporary.fill(walk.swept(), walk.infinite());
    });
}

std::vector<dxGeom *> dxOrderedSapSpace::geomsIn(const std::vector<Slot> &slots) const {
    std::vector<dxGeom *> geoms;
    for (const Slot slot : slots) geoms.push_back(members().geomIn(slot));
    return geoms;
}

void dxOrderedSapSpace::findPairsOf(dxSapWalk &sweep) {
    beforeCallbacks([&] {
        const std::vector<dxSapLists::Entry> &list = m_lists.clean();
        sweep.begin(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i + kPrefetchDistance < list.size()) dxPrefetch::line(list[i + kPrefetchDistance].geom->aabb);
            if (dxGeomIsEnabled(list[i].geom)) sweep.add(list[i].geom);
        }
        sweep.findPairs(m_sort);
    });
}

// As upstream, whatever is known of the members.
void dxOrderedSapSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    if (isWorthAnIndex() || !m_lists.dirty().empty()) return dxOrderedSpace::collide2(data, geom, callback);
    collideClean(geom, callback, [&] { collideFrom(0, data, geom, callback); });
}

void dxOrderedSapSpace::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    if (m_walking && isWorthAnIndex()) m_walking.query([this] { stopWalking(); });
    if (!isWorthAnIndex() || hasStrays() || m_walking)
        collideFrom(0, data, geom, callback);
    else if (const dxGeom *const last = collideRegion(data, geom, callback))
        collideFrom(m_lists.placeOf(slotOf(last)) + 1, data, geom, callback);
}

void dxOrderedSapSpace::collideFrom(std::size_t place, void *data, dxGeom *geom, dNearCallback *callback) {
    const std::vector<dxSapLists::Entry> &list = m_lists.clean();
    dxGeomQuery query(data, geom, callback);
    for (; place < list.size(); ++place) query.meet(list[place].geom);
    noteMet(query.met());
}
