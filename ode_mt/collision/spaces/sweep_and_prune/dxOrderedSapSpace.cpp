#include "collision/spaces/sweep_and_prune/dxOrderedSapSpace.h"

#include "collision/pairs/dxPairPrefetch.h"
#include "collision/spaces/dxGeomQuery.h"
#include "collision/spaces/dxPairDelivery.h"
#include "core/dxPrefetch.h"

#include "util.h"

namespace {

// Pairs per geom, above which the memory of a walk is freed after it.
constexpr std::size_t kMaxPairsPerGeomKept = 2 * dxBroadphaseThresholds::kMaxComparisonsWalked;

}  // namespace

// If the axes are not all three, upstream's sweep reports pairs that do not overlap, which no broad phase finds.
dxOrderedSapSpace::dxOrderedSapSpace(dSpaceID parent, int axes)
    : dxOrderedSpace(parent, dSweepAndPruneSpaceClass, dxPairOrder::Axis, m_cleaner, m_order, m_walker, dxSapAxes(axes).areAll()), m_state(axes),
      m_lastWalk(m_state.axes), m_cleaner(geoms(), foundPairs(), m_state, m_lastWalk),
      m_order(geoms(), foundPairs(), m_state, m_cleaner.lists()), m_walker(*this, m_state, m_lastWalk, m_cleaner, m_order) {
    dInfiniteAABB(this, aabb);
}

// As upstream, removes geoms from the fronts of the two lists, whatever a destructor of a user's geom moves, adds or destroys meanwhile. Geoms that
// become dirty after the first list was emptied are left to the destructors of the base classes.
dxOrderedSapSpace::~dxOrderedSapSpace() {
    if (lock_count != 0) dDebug(d_ERR_UASSERT, "Invalid operation for locked space in %s()", "~dxSAPSpace");
    const auto empty = [this](const std::vector<dxSapLists::Entry> &list) {
        while (!list.empty()) {
            if (cleanup)
                dGeomDestroy(list.front().geom);
            else
                remove(list.front().geom);
        }
    };
    empty(m_cleaner.lists().dirty());
    empty(m_cleaner.lists().clean());
}

dxGeom *dxOrderedSapSpace::getGeom(int i) {
    dUASSERT(i >= 0 && i < count, "index out of range");
    const dxSapLists &lists = m_cleaner.lists();
    const auto at = static_cast<std::size_t>(i), dirtyOnes = lists.dirty().size();
    return at < dirtyOnes ? lists.dirty()[at].geom : lists.clean()[at - dirtyOnes].geom;
}

// A clean space that is too small for an index is queried as upstream does, without a look at what is kept of its members.
void dxOrderedSapSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    if (geoms().isWorthAnIndex() || !m_cleaner.lists().dirty().empty()) return dxOrderedSpace::collide2(data, geom, callback);
    dxCollideClean(geoms(), geom, callback, [&] { m_walker.collideFrom(0, data, geom, callback); });
}

// ---- Callbacks -------------------------------------------------------------------------------------------------------------------------

void dxSapWalker::deliver(void *data, dNearCallback *callback) {
    const std::vector<dxOrderedPair> &pairs = m_space.pairs();
    dxNarrowphasePrefetch *const prefetch = m_space.activePrefetch();
    const std::uint64_t missed = dxMissedNotifications.count();
    const unsigned fills = m_lastWalk.lists().fills();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (prefetch != nullptr) prefetch->beforePair(pairs, i);
        dxPairPrefetch::forCallback(pairs, i);
        dxSapWalk::requireCleanBoxes(pairs[i].first, pairs[i].second);
        dxDeliver(pairs[i], data, callback);
        if (dxMissedNotifications.count() == missed && m_lastWalk.lists().fills() == fills) continue;
        const dxOrderedPair last = pairs[i];
        return deliverBehind(last, fills, data, callback);
    }
}

// Like deliver().
void dxSapWalker::deliverAnew(void *data, dNearCallback *callback) {
    m_space.geoms().beforeCallbacks([this] { m_order.gatherRows(); });
    const std::uint64_t missed = dxMissedNotifications.count();
    const unsigned fills = m_lastWalk.lists().fills();
    dxForPairsOf(m_order.rows(), m_space.foundPairs(), [](const dxGeom *) { return true; }, [&](const dxOrderedPair &pair) {
        dxSapWalk::requireCleanBoxes(pair.first, pair.second);
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed && m_lastWalk.lists().fills() == fills) return true;
        deliverBehind(pair, fills, data, callback);
        return false;
    });
    m_state.comparisons = m_order.rows().comparisons();
}

// Goes through upstream's pairs behind this one. Pairs that bits or bodies exclude get upstream's assertion too, but no callback. It is called when
// an assertion in a callback may have left a box that is not up to date, for which upstream's next assertion fails; or when a nested call has
// refilled the lists.
void dxSapWalker::deliverBehind(const dxOrderedPair &after, unsigned fills, void *data, dNearCallback *callback) {
    const std::vector<Slot> &swept = m_order.swept();
    dxSapWalk rest(m_state.axes);
    rest.begin(swept.size());
    std::vector<std::uint32_t> places(m_state.members.size()), order;
    for (std::size_t i = 0; i < swept.size(); ++i) {
        const Slot slot = swept[i];
        places[slot] = static_cast<std::uint32_t>(i);
        rest.add(m_space.members().geomIn(slot), m_state.members[slot].box);
    }
    for (const Slot slot : m_order.infinite()) rest.addInfinite(m_space.members().geomIn(slot));
    for (const Slot slot : m_order.inOrder()) order.push_back(places[slot]);
    rest.findPairs(order);
    rest.deliver(data, callback, m_lastWalk.lists(), fills, &after);
}

// `after` is always NULL: the rest of a call is delivered by deliverBehind().
void dxSapWalker::walk(void *data, dNearCallback *callback, const dxOrderedPair * /*after*/) {
    m_lastWalk.noteSorted();
    const dxSpaceGeoms &geoms = m_space.geoms();
    const bool isOutermost = geoms.walking() && geoms.isOutermostCall();
    if (isOutermost) m_lastWalk.noteDelivered();
    if (isOutermost && m_lastWalk.isCurrent(geoms) && geoms.isSure())
        return m_lastWalk.walk().deliver(data, callback, m_lastWalk.lists(), m_lastWalk.lists().fills());
    dxSapWalk once(m_state.axes);
    dxSapWalk &walk = isOutermost ? m_lastWalk.walk() : once;
    findPairsOf(walk);
    m_state.comparisons = walk.comparisons();
    if (isOutermost) {
        if (walk.isRepeatable() && m_state.axes.areAll())  // otherwise a geom's bits may be bounds
            m_lastWalk.setCurrent(geoms);
        else
            m_lastWalk.invalidate();
    } else {
        fillLists(once);
    }
    walk.deliver(data, callback, m_lastWalk.lists(), m_lastWalk.lists().fills());
    if (isOutermost && walk.pairs() > kMaxPairsPerGeomKept * static_cast<std::size_t>(geoms.count())) m_lastWalk.discard();
}

// Requires a nested call, or one whose walk is not kept.
void dxSapWalker::fillLists(const dxSapWalk &walk) {
    dxSapTemporaryLists &lists = m_lastWalk.lists();
    m_space.geoms().beforeCallbacks([&] {
        if (!m_space.geoms().isOutermostCall() && lists.isFirst()) {
            if (m_lastWalk.isDelivered())
                lists.fill(m_lastWalk.walk().swept(), m_lastWalk.walk().infinite());
            else
                lists.fill(geomsIn(m_order.swept()), geomsIn(m_order.infinite()));
        }
        lists.fill(walk.swept(), walk.infinite());
    });
}

std::vector<dxGeom *> dxSapWalker::geomsIn(const std::vector<Slot> &slots) const {
    std::vector<dxGeom *> geoms;
    for (const Slot slot : slots) geoms.push_back(m_space.members().geomIn(slot));
    return geoms;
}

void dxSapWalker::findPairsOf(dxSapWalk &walk) {
    m_space.geoms().beforeCallbacks([&] {
        const std::vector<dxSapLists::Entry> &list = m_cleaner.lists().clean();
        walk.begin(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i + kSapPrefetchDistance < list.size()) dxPrefetch::line(list[i + kSapPrefetchDistance].geom->aabb);
            if (dxGeomIsEnabled(list[i].geom)) walk.add(list[i].geom);
        }
        walk.findPairs(m_state.sort);
    });
}

void dxSapWalker::collideWith(void *data, dxGeom *geom, dNearCallback *callback) {
    dxSpaceGeoms &geoms = m_space.geoms();
    if (geoms.walking() && geoms.isWorthAnIndex()) geoms.walking().query([this] { m_cleaner.stopWalking(); });
    if (!geoms.isWorthAnIndex() || geoms.hasStaleGeoms() || geoms.walking())
        collideFrom(0, data, geom, callback);
    else if (const dxGeom *const last = dxCollideRegion(geoms, data, geom, callback))
        collideFrom(m_cleaner.lists().placeOf(dxSpaceGeoms::slotOf(last)) + 1, data, geom, callback);
}

void dxSapWalker::collideFrom(std::size_t place, void *data, dxGeom *geom, dNearCallback *callback) {
    const std::vector<dxSapLists::Entry> &list = m_cleaner.lists().clean();
    dxGeomQuery query(data, geom, callback);
    for (; place < list.size(); ++place) query.meet(list[place].geom);
    m_space.geoms().noteMet(query.met());
}
