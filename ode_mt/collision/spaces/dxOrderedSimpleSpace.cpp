#include "collision/spaces/dxOrderedSimpleSpace.h"

#include <new>

#include "collision/narrowphase/dxTransformedGeom.h"

#include "util.h"

// What moves in a small space is compared with the others as upstream does, and nothing else is done. One at rest keeps its pairs, unless it
// has so few geoms that comparing them takes no longer.
void dxOrderedSimpleSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    dxTransformedGeom::noticeLeft();
    const bool isAsQuick = hasDirty() || count <= dxBroadphaseThresholds::kMaxNeverKept, isUnseen = !isRecorded() || dxTimeline::isOff();
    if (!isAsQuick || !isUnseen || !isWalkedOnly() || narrowphasePrefetch() != nullptr) return dxOrderedSpace::collide(data, callback);
    lock_count++;
    if (hasDirty()) cleanWalked();
    if (first != nullptr) walkFrom(nullptr, first, data, callback);
    lock_count--;
}

void dxOrderedSimpleSpace::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    if (after != nullptr)
        walkFrom(after->first, after->second->next, data, callback);
    else if (!walkRows(data, callback) && first != nullptr)
        walkFrom(nullptr, first, data, callback);  // with upstream's assertions where boxes are not up to date
}

// Returns false if the list must be walked: it is short, or boxes are not up to date, or there is no memory for rows, or a call around
// this one uses them. In a small space it is quicker to find all pairs before the first is delivered, unless they are many.
bool dxOrderedSimpleSpace::walkRows(void *data, dNearCallback *callback) {
    using Threshold = dxBroadphaseThresholds;
    if (count < Threshold::kMinWalkedByVectors || lock_count > 1) return false;
    const bool isSmall = count <= Threshold::kMaxWalked && m_overlapsWalked <= Threshold::kMaxListedPerGeom * static_cast<std::size_t>(count);
    try {
        if (isSmall ? !findListed() : !areBoxesUpToDate()) return false;
        if (!isSmall) gatherRows();
    } catch (const std::bad_alloc &) {
        return false;
    }
    if (isSmall) {
        deliverInOrder(m_walked, data, callback);
    } else {
        deliverRows(m_rows, data, callback);
        m_overlapsWalked = m_rows.overlaps();
    }
    return true;
}

// Returns false if some boxes are not up to date.
bool dxOrderedSimpleSpace::findListed() {
    m_listed.clear();
    m_boxes.clear();
    for (dxGeom *geom = first; geom != nullptr; geom = geom->next) {
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

// The first geom with the second and those behind it; then each behind the first. Whether the first is
// enabled was asked when its turn came. NULL: none.
void dxOrderedSimpleSpace::walkFrom(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback) {
    for (; g1 != nullptr && g2 != nullptr; g2 = g2->next)
        if (dxGeomIsEnabled(g2)) dxCollideBoxes(g1, g2, data, callback, dxOverlapInTurn);
    for (g1 = g1 != nullptr ? g1->next : first; g1 != nullptr; g1 = g1->next) {
        if (!dxGeomIsEnabled(g1)) continue;
        for (g2 = g1->next; g2 != nullptr; g2 = g2->next)
            if (dxGeomIsEnabled(g2)) dxCollideBoxes(g1, g2, data, callback, dxOverlapInTurn);
    }
}

bool dxOrderedSimpleSpace::areBoxesUpToDate() const {
    for (const dxGeom *geom = first; geom != nullptr; geom = geom->next)
        if ((geom->gflags & GEOM_AABB_BAD) != 0) return false;
    return true;
}

void dxOrderedSimpleSpace::deliverAnew(void *data, dNearCallback *callback) {
    beforeCallbacks([this] { gatherRows(); });
    deliverRows(m_rows, data, callback);
}

dxPairRows &dxOrderedSimpleSpace::gatherRows() {
    m_rows.clear();
    for (dxGeom *geom = first; geom != nullptr; geom = geom->next)
        if (dxGeomIsEnabled(geom)) m_rows.push(geom, slotOf(geom), dxFilterOf(geom), dxBounds(geom->aabb));
    m_rows.finish();
    return m_rows;
}
