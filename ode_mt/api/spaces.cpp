// Spaces of all kinds, which are ours, and the entry to a frame's collisions (ode/collision_space.h).
#include <ode/collision_space.h>

#include "frame/dxClusterManager.h"
#include "collision/dxOrderedHashSpace.h"
#include "collision/dxOrderedQuadTreeSpace.h"
#include "collision/dxOrderedSimpleSpace.h"
#include "collision/dxOrderedSweepSpace.h"
#include "frame/dxSettings.h"
#include "frame/dxSpaceCollision.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/collision_space.h.
void dxUpstreamSpaceCollide(dSpaceID space, void *data, dNearCallback *callback);

dSpaceID dSimpleSpaceCreate(dSpaceID space) { return new dxOrderedSimpleSpace(space); }

dSpaceID dHashSpaceCreate(dSpaceID space) { return new dxOrderedHashSpace(space); }

dSpaceID dQuadTreeSpaceCreate(dSpaceID space, const dVector3 center, const dVector3 extents, int depth) {
    return new dxOrderedQuadTreeSpace(space, center, extents, depth);
}

dSpaceID dSweepAndPruneSpaceCreate(dSpaceID space, int axisorder) { return new dxOrderedSweepSpace(space, axisorder); }

void dHashSpaceSetLevels(dSpaceID space, int minlevel, int maxlevel) {
    dAASSERT(space);
    dUASSERT(minlevel <= maxlevel, "must have minlevel <= maxlevel");
    dUASSERT(space->type == dHashSpaceClass, "argument must be a hash space");
    static_cast<dxOrderedHashSpace *>(space)->setLevels({minlevel, maxlevel});
}

void dHashSpaceGetLevels(dSpaceID space, int *minlevel, int *maxlevel) {
    dAASSERT(space);
    dUASSERT(space->type == dHashSpaceClass, "argument must be a hash space");
    const dxHashLevels &levels = static_cast<dxOrderedHashSpace *>(space)->levels();
    if (minlevel != nullptr) *minlevel = levels.lowest;
    if (maxlevel != nullptr) *maxlevel = levels.highest;
}

void dSpaceCollide(dSpaceID space, void *data, dNearCallback *callback) {
    if (space != nullptr && callback != nullptr && dGeomIsSpace(space)) {
        const dxSettings &settings = dxSettings::instance();
        dxClusterManager::prepare(space, settings.passName());
        if (dxOrderedSpace *const ordered = dxOrderedSpace::from(space)) return dxCollideSpace(*ordered, data, callback);
    }
    dxUpstreamSpaceCollide(space, data, callback);
}

}  // extern "C"
