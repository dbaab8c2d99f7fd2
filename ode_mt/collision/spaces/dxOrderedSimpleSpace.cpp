#include "collision/spaces/dxOrderedSimpleSpace.h"

#include <new>

#include "collision_space_internal.h"
#include "util.h"

void dxOrderedSimpleSpace::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    if (after != nullptr)
        walkFrom(after->first, after->second->next, data, callback);
    else if (!walkRows(data, callback) && first != nullptr)
        walkFrom(nullptr, first, data, callback);  // with upstream's assertions where boxes are not up to date
}

// Returns false if the list must be walked: it is short, or boxes are not up to date, or there is no memory for rows, or a call around
// this one uses them.
bool dxOrderedSimpleSpace::walkRows(void *data, dNearCallback *callback) {
    if (count < dxBroadphaseThresholds::kMinWalkedByVectors || lock_count > 1 || !areBoxesUpToDate()) return false;
    try {
        gatherRows();
    } catch (const std::bad_alloc &) {
        return false;
    }
    deliverRows(m_rows, data, callback);
    return true;
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

bool dxOrderedSimpleSpace::areBoxesUpToDate() const {
    for (const dxGeom *geom = first; geom != nullptr; geom = geom->next)
        if ((geom->gflags & GEOM_AABB_BAD) != 0) return false;
    return true;
}

dxPairRows &dxOrderedSimpleSpace::gatherRows() {
    m_rows.clear();
    for (dxGeom *geom = first; geom != nullptr; geom = geom->next)
        if (dxGeomIsEnabled(geom)) m_rows.push(geom, slotOf(geom), dxFilterOf(geom), dxBounds(geom->aabb));
    m_rows.finish();
    return m_rows;
}
