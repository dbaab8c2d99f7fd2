#include "collision/spaces/dxOrderedSimpleSpace.h"

#include <new>

#include "collision_space_internal.h"
#include "util.h"

// The memory is the outermost call's: one within it, in a callback, walks the list.
void dxOrderedSimpleSpace::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    if (after != nullptr) {
        walkFrom(after->first, after->second->next, data, callback);
        return;
    }
    const bool isWorthATable = count >= dxBroadphaseThresholds::kMinWalkedByVectors;
    if (!isWorthATable || hasPairOverflow() || lock_count > 1 || !findVectorised()) {
        walkList(data, callback);
        return;
    }
    deliverInOrder(m_walked, data, callback);
}

// False: some boxes are not up to date, or there is no memory for it.
bool dxOrderedSimpleSpace::findVectorised() try {
    if (!listGeoms()) return false;
    findListed();
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

// As upstream, with its assertions where boxes are not up to date.
void dxOrderedSimpleSpace::walkList(void *data, dNearCallback *callback) {
    if (first != nullptr) walkFrom(nullptr, first, data, callback);
}

// The first geom with the second and those behind it; then each behind the first. Whether the first is
// enabled was asked when its turn came. NULL: none.
void dxOrderedSimpleSpace::walkFrom(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback) {
    for (; g1 != nullptr && g2 != nullptr; g2 = g2->next)
        if (dxGeomIsEnabled(g2)) collideAABBs(g1, g2, data, callback);
    for (g1 = g1 != nullptr ? g1->next : first; g1 != nullptr; g1 = g1->next) {
        if (!dxGeomIsEnabled(g1)) continue;
        for (g2 = g1->next; g2 != nullptr; g2 = g2->next)
            if (dxGeomIsEnabled(g2)) collideAABBs(g1, g2, data, callback);
    }
}

// False: some boxes are not up to date.
bool dxOrderedSimpleSpace::listGeoms() {
    m_listed.clear();
    m_boxes.clear();
    for (dxGeom *geom = first; geom != nullptr; geom = geom->next) {
        if ((geom->gflags & GEOM_AABB_BAD) != 0) return false;
        if (!dxGeomIsEnabled(geom)) continue;
        m_listed.push_back(geom);
        m_boxes.push(dxBounds(geom->aabb));
    }
    return true;
}

void dxOrderedSimpleSpace::findListed() {
    m_walked.clear();
    const std::size_t overlaps = dxOverlappingPairs(m_boxes, m_boxes.size(), m_overlaps);
    for (std::size_t i = 0; i < overlaps; ++i) {
        dxGeom *const first = m_listed[m_overlaps[i].a], *const second = m_listed[m_overlaps[i].b];
        if (dxFiltersAgree(dxFilterOf(first), dxFilterOf(second))) m_walked.push_back({first, second, {}});
    }
}
