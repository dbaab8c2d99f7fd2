#include "collision/dxOrderedSimpleSpace.h"

#include <algorithm>

#include "util.h"
#include "collision_space_internal.h"

void dxOrderedSimpleSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    lock_count++;
    cleanGeoms();
    if (refresh())
        collidePairs(data, callback);
    else
        collideList(data, callback);
    lock_count--;
}

bool dxOrderedSimpleSpace::place(Slot a, Slot b, dxPairKey &key, bool &swapped) const {
    swapped = rankOf(a) < rankOf(b);
    key.words = {dxFrontFirst(std::max(rankOf(a), rankOf(b))), dxFrontFirst(std::min(rankOf(a), rankOf(b))), 0, 0};
    return true;
}

// Upstream asks whether a geom is enabled once before it is paired with those behind it, and of each of
// those when its turn comes. A callback may enable or disable either.
void dxOrderedSimpleSpace::collidePairs(void *data, dNearCallback *callback) {
    const dxGeom *front = nullptr;
    bool frontIsEnabled = false;
    for (const dxOrderedPair &pair : pairs()) {
        if (pair.first != front) {
            front = pair.first;
            frontIsEnabled = dxGeomIsEnabled(front);
        }
        if (frontIsEnabled && dxGeomIsEnabled(pair.second)) dxDeliver(pair, data, callback);
    }
}

void dxOrderedSimpleSpace::collideList(void *data, dNearCallback *callback) {
    for (dxGeom *g1 = first; g1 != nullptr; g1 = g1->next) {
        if (!dxGeomIsEnabled(g1)) continue;
        for (dxGeom *g2 = g1->next; g2 != nullptr; g2 = g2->next)
            if (dxGeomIsEnabled(g2)) collideAABBs(g1, g2, data, callback);
    }
}
