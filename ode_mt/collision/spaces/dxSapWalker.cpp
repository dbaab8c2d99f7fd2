#include "collision/spaces/dxSapWalker.h"

#include "collision/pairs/dxPairPrefetch.h"
#include "collision/spaces/dxGeomQuery.h"
#include "collision/spaces/dxPairDelivery.h"
#include "core/dxPrefetch.h"

namespace {

// If a walk finds more pairs they are not left in memory.
constexpr std::size_t kMaxPairsPerGeomKept = 2 * dxBroadphaseThresholds::kMaxComparisonsWalked;

}  // namespace

void dxSapWalker::deliver(void *data, dNearCallback *callback) {
    const std::vector<dxOrderedPair> &pairs = m_space.pairs();
    dxNarrowphasePrefetch *const ahead = m_space.ahead();
    const std::uint64_t missed = dxMissedNotifications.count();
    const unsigned fills = m_state.temporary.fills();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (ahead != nullptr) ahead->beforePair(pairs, i);
        dxPairPrefetch::forCallback(pairs, i);
        dxSapWalk::requireCleanBoxes(pairs[i].first, pairs[i].second);
        dxDeliver(pairs[i], data, callback);
        if (dxMissedNotifications.count() == missed && m_state.temporary.fills() == fills) continue;
        const dxOrderedPair last = pairs[i];
        return deliverBehind(last, fills, data, callback);
    }
}

// As deliver().
void dxSapWalker::deliverAnew(void *data, dNearCallback *callback) {
    m_space.geoms().beforeCallbacks([this] { m_order.gatherRows(); });
    const std::uint64_t missed = dxMissedNotifications.count();
    const unsigned fills = m_state.temporary.fills();
    dxForPairsOf(m_order.rows(), m_space.foundPairs(), [](const dxGeom *) { return true; }, [&](const dxOrderedPair &pair) {
        dxSapWalk::requireCleanBoxes(pair.first, pair.second);
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed && m_state.temporary.fills() == fills) return true;
        deliverBehind(pair, fills, data, callback);
        return false;
    });
    m_state.comparisons = m_order.rows().comparisons();
}

// Upstream's pairs from the one behind this on, with those that bits or bodies exclude: an assertion in a callback may have left a geom whose box is
// not up to date, for which the next one fails; or a call within this one has filled the lists anew.
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
    rest.deliver(data, callback, m_state.temporary, fills, &after);
}

// Upstream goes through a list of pairs, as deliver() does.
void dxSapWalker::walk(void *data, dNearCallback *callback, const dxOrderedPair * /*after*/) {
    m_state.hasWalked = true;
    const dxSpaceGeoms &geoms = m_space.geoms();
    const bool isOutermost = geoms.walking() && geoms.isOutermostCall();
    if (isOutermost) m_state.noteSweepDelivered();
    if (isOutermost && m_state.isSweepCurrent(geoms) && geoms.isSure())
        return m_state.sweep().deliver(data, callback, m_state.temporary, m_state.temporary.fills());
    dxSapWalk once(m_state.axes);
    dxSapWalk &sweep = isOutermost ? m_state.sweep() : once;
    findPairsOf(sweep);
    m_state.comparisons = sweep.comparisons();
    if (isOutermost) {
        if (sweep.isRepeatable() && m_state.axes.areAll())  // or else a geom's bits may be bounds
            m_state.setSweepCurrent(geoms);
        else
            m_state.invalidateSweep();
    } else {
        fillTemporary(once);
    }
    sweep.deliver(data, callback, m_state.temporary, m_state.temporary.fills());
    if (isOutermost && sweep.pairs() > kMaxPairsPerGeomKept * static_cast<std::size_t>(geoms.count())) m_state.discardSweep();
}

// Of a call within another one, or of one whose walk is not kept.
void dxSapWalker::fillTemporary(const dxSapWalk &walk) {
    dxSapTemporaryLists &temporary = m_state.temporary;
    m_space.geoms().beforeCallbacks([&] {
        if (!m_space.geoms().isOutermostCall() && temporary.isFirst()) {
            if (m_state.isSweepDelivered())
                temporary.fill(m_state.sweep().swept(), m_state.sweep().infinite());
            else
                temporary.fill(geomsIn(m_order.swept()), geomsIn(m_order.infinite()));
        }
        temporary.fill(walk.swept(), walk.infinite());
    });
}

std::vector<dxGeom *> dxSapWalker::geomsIn(const std::vector<Slot> &slots) const {
    std::vector<dxGeom *> geoms;
    for (const Slot slot : slots) geoms.push_back(m_space.members().geomIn(slot));
    return geoms;
}

void dxSapWalker::findPairsOf(dxSapWalk &sweep) {
    m_space.geoms().beforeCallbacks([&] {
        const std::vector<dxSapLists::Entry> &list = m_cleaner.lists().clean();
        sweep.begin(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i + kSapPrefetchDistance < list.size()) dxPrefetch::line(list[i + kSapPrefetchDistance].geom->aabb);
            if (dxGeomIsEnabled(list[i].geom)) sweep.add(list[i].geom);
        }
        sweep.findPairs(m_state.sort);
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
