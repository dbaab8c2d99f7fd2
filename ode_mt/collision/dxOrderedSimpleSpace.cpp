#include "collision/dxOrderedSimpleSpace.h"

#include "util.h"
#include "collision_space_internal.h"

void dxOrderedSimpleSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    beginCollide();
    if (makeReady())
        deliverByRank(data, callback);
    else
        collideList(data, callback);
    lock_count--;
}

void dxOrderedSimpleSpace::collideList(void *data, dNearCallback *callback) {
    for (dxGeom *g1 = first; g1 != nullptr; g1 = g1->next) {
        if (!dxGeomIsEnabled(g1)) continue;
        for (dxGeom *g2 = g1->next; g2 != nullptr; g2 = g2->next)
            if (dxGeomIsEnabled(g2)) collideAABBs(g1, g2, data, callback);
    }
}
