// Functions of ode/objects.h: worlds and joints.
#include <ode/memory.h>
#include <ode/objects.h>

#include "collision/callbacks/dxConcurrentCallbacks.h"
#include "collision/pairs/dxUnnoticedChanges.h"
#include "settings/dxJointAttachment.h"
#include "dynamics/step/dxJointRemoval.h"
#include "seams/upstream.h"
#include "settings/dxLentThreads.h"
#include "settings/dxWorldState.h"

extern "C" {

// A world's threading implementation may be freed after these two: its threads must have left this library by then.

void dWorldSetStepThreadingImplementation(dWorldID world, const dThreadingFunctionsInfo *functions,
                                          dThreadingImplementationID implementation) {
    if (world != nullptr) dxWorldWorkers::giveBack(world);
    dxUpstreamWorldSetStepThreadingImplementation(world, functions, implementation);
    dxWorldWorkers::lend(world);
}

void dWorldDestroy(dWorldID world) {
    if (world != nullptr) {
        dxWorldWorkers::giveBack(world);
        dxWorldState::forget(world);
    }
    dxUpstreamWorldDestroy(world);
}

// Contact joints: where callbacks run on several threads, they are put into their lists later (collision/callbacks/dxConcurrentCallbacks.h).
// They are removed without taking memory (dynamics/step/dxJointRemoval.h). A joint of any type that is attached during a step may concern
// it (settings/dxJointAttachment.h).

dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact) {
    dxContactLog *const log = dxContactLog::current();
    return log == nullptr ? dxUpstreamJointCreateContact(world, group, contact)
                          : log->create(world, group, contact);
}

void dJointAttach(dJointID joint, dBodyID body1, dBodyID body2) {
    dxContactLog *const log = dxContactLog::current();
    if (log == nullptr)
        dxJointAttachment::attach(joint, body1, body2);
    else
        log->attach(joint, body1, body2);
}

// Upstream lists the joints in memory that it takes from the user's allocator, if there is one, who may count
// that.
void dJointGroupEmpty(dJointGroupID group) {
    if (group == nullptr || dGetAllocHandler() != nullptr || !dxRemoveJoints(*group))
        dxUpstreamJointGroupEmpty(group);
}

// These move a body to and fro while they compute anchors: its position comes back rounded, and contacts that were computed
// from it hear of that (collision/pairs/dxUnnoticedChanges.h).

void dJointSetPistonAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz) {
    dxSilentChanges.add();
    dxUpstreamJointSetPistonAnchorOffset(joint, x, y, z, dx, dy, dz);
}

void dJointSetPUAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz) {
    dxSilentChanges.add();
    dxUpstreamJointSetPUAnchorDelta(joint, x, y, z, dx, dy, dz);
}

void dJointSetPUAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz) {
    dxSilentChanges.add();
    dxUpstreamJointSetPUAnchorOffset(joint, x, y, z, dx, dy, dz);
}

}  // extern "C"
