// Functions of ode/collision_space.h: spaces of all kinds are ours.
#include <ode/collision_space.h>

#include "collision/spaces/hash/dxOrderedHashSpace.h"
#include "collision/spaces/quad_tree/dxOrderedQuadTreeSpace.h"
#include "collision/spaces/dxOrderedSimpleSpace.h"
#include "collision/spaces/sweep_and_prune/dxOrderedSapSpace.h"

extern "C" {

dSpaceID dSimpleSpaceCreate(dSpaceID space) { return new dxOrderedSimpleSpace(space); }

dSpaceID dHashSpaceCreate(dSpaceID space) { return new dxOrderedHashSpace(space); }

dSpaceID dQuadTreeSpaceCreate(dSpaceID space, const dVector3 center, const dVector3 extents, int depth) {
    return new dxOrderedQuadTreeSpace(space, center, extents, depth);
}

dSpaceID dSweepAndPruneSpaceCreate(dSpaceID space, int axisorder) { return new dxOrderedSapSpace(space, axisorder); }

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

}  // extern "C"
