// Creation and levels of simple and hash spaces (ode/collision_space.h), which are ours.
#include <ode/collision_space.h>

#include "collision/dxOrderedHashSpace.h"
#include "collision/dxOrderedSimpleSpace.h"

extern "C" {

dSpaceID dSimpleSpaceCreate(dSpaceID space) { return new dxOrderedSimpleSpace(space); }

dSpaceID dHashSpaceCreate(dSpaceID space) { return new dxOrderedHashSpace(space); }

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
