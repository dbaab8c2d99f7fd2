#include "collision/spaces/dxOrderedSimpleSpace.h"

#include <new>

#include "collision/narrowphase/dxHeightField.h"
#include "collision/spaces/dxPairDelivery.h"

#include "util.h"

// A small space whose geoms move is walked as upstream does, and nothing else is done. A space at rest keeps its pairs, unless it has so few geoms
// that a walk is as fast.
void dxOrderedSimpleSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    dxTransformedGeom::noticeLeft();
    const bool isWalkAsFast = m_cleaner.hasDirty() || count <= dxBroadphaseThresholds::kMaxNeverKept;
    const bool isUnrecorded = !isRecorded() || dxTimeline::isOff();
    if (!isWalkAsFast || !isUnrecorded || !m_cleaner.isWalkedOnly() || narrowphasePrefetch() != nullptr)
        return dxOrderedSpace::collide(data, callback);
    lock_count++;
    if (m_cleaner.hasDirty()) m_cleaner.cleanWalked();
    if (first != nullptr) m_walker.walkFrom(nullptr, first, data, callback);
    lock_count--;
}

dxPairRows &dxOrderedSimpleSpace::Order::gatherRows() {
    m_rows.clear();
    for (dxGeom *geom = geoms().space().first; geom != nullptr; geom = geom->next)
        if (dxGeomIsEnabled(geom)) m_rows.push(geom, dxSpaceGeoms::slotOf(geom), dxFilterOf(geom), dxBounds(geom->aabb));
    m_rows.finish();
    return m_rows;
}

void dxOrderedSimpleSpace::Walker::deliver(void *data, dNearCallback *callback) { dxDeliverInOrder(m_space, *this, m_space.pairs(), data, callback); }

void dxOrderedSimpleSpace::Walker::deliverAnew(void *data, dNearCallback *callback) {
    m_space.geoms().beforeCallbacks([this] { m_order.gatherRows(); });
    dxDeliverRows(m_order.rows(), m_space, *this, data, callback);
}

void dxOrderedSimpleSpace::Walker::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    if (after != nullptr)
        walkFrom(after->first, after->second->next, data, callback);
    else if (!walkRows(data, callback) && m_space.first != nullptr)
        walkFrom(nullptr, m_space.first, data, callback);  // with upstream's assertions where boxes are not up to date
}

// Walks with SIMD. Returns false if the list must be walked geom by geom: it is short, boxes are not up to date, there is no memory for rows, or an
// outer call uses the rows. In a small space it is faster to find all pairs before the first is delivered, unless there are many.
bool dxOrderedSimpleSpace::Walker::walkRows(void *data, dNearCallback *callback) {
    using Threshold = dxBroadphaseThresholds;
    const int count = m_space.count;
    if (count < Threshold::kMinWalkedWithSimd || m_space.lock_count > 1) return false;
    const bool isSmall = count <= Threshold::kMaxWalked && m_overlapsWalked <= Threshold::kMaxListedPerGeom * static_cast<std::size_t>(count);
    try {
        if (isSmall ? !findListed() : !areBoxesUpToDate()) return false;
        if (!isSmall) m_order.gatherRows();
    } catch (const std::bad_alloc &) {
        return false;
    }
    if (isSmall) {
        dxDeliverInOrder(m_space, *this, m_walked, data, callback);
    } else {
        dxDeliverRows(m_order.rows(), m_space, *this, data, callback);
        m_overlapsWalked = m_order.rows().overlaps();
    }
    return true;
}

// Returns false if some boxes are not up to date.
bool dxOrderedSimpleSpace::Walker::findListed() {
    m_listed.clear();
    m_boxes.clear();
    for (dxGeom *geom = m_space.first; geom != nullptr; geom = geom->next) {
        if ((geom->gflags & GEOM_AABB_BAD) != 0) return false;
        if (!dxGeomIsEnabled(geom)) continue;
        m_listed.push_back(geom);
        m_boxes.push(dxBounds(geom->aabb));
    }
    m_walked.clear();
    m_overlapsWalked = dxOverlappingPairs(m_boxes, m_boxes.size(), m_overlaps);
    for (std::size_t i = 0; i < m_overlapsWalked; ++i) {
        dxGeom *const first = m_listed[m_overlaps[i].a], *const second = m_listed[m_overlaps[i].b];
        if (dxFiltersAgree(dxFilterOf(first), dxFilterOf(second))) m_walked.push_back({first, second, {}});
    }
    return true;
}

bool dxOrderedSimpleSpace::Walker::areBoxesUpToDate() const {
    for (const dxGeom *geom = m_space.first; geom != nullptr; geom = geom->next)
        if ((geom->gflags & GEOM_AABB_BAD) != 0) return false;
    return true;
}

// Pairs g1 with g2 and the geoms behind g2; then each geom behind g1 with those behind it. As in upstream, whether g1 is enabled was tested before
// its first pair.
void dxOrderedSimpleSpace::Walker::walkFrom(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback) {
    for (; g1 != nullptr && g2 != nullptr; g2 = g2->next)
        if (dxGeomIsEnabled(g2)) dxCollideBoxes(g1, g2, data, callback, dxOverlapInTurn);
    for (g1 = g1 != nullptr ? g1->next : m_space.first; g1 != nullptr; g1 = g1->next) {
        if (!dxGeomIsEnabled(g1)) continue;
        for (g2 = g1->next; g2 != nullptr; g2 = g2->next)
            if (dxGeomIsEnabled(g2)) dxCollideBoxes(g1, g2, data, callback, dxOverlapInTurn);
    }
}
