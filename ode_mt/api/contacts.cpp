// Contact joints (ode/objects.h). Where callbacks run on several threads, they are put into their lists later
// (collision/dxContactLog.h). They are removed without taking memory (collision/dxJointRemoval.h).
#include <ode/memory.h>
#include <ode/objects.h>

#include "collision/dxContactLog.h"
#include "collision/dxJointRemoval.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/ode.h.
dJointID dxUpstreamJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact);
void dxUpstreamJointAttach(dJointID joint, dBodyID body1, dBodyID body2);
void dxUpstreamJointGroupEmpty(dJointGroupID group);

dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact) {
    dxContactLog *const log = dxContactLog::current();
    return log == nullptr ? dxUpstreamJointCreateContact(world, group, contact)
                          : log->create(world, group, contact);
}

void dJointAttach(dJointID joint, dBodyID body1, dBodyID body2) {
    dxContactLog *const log = dxContactLog::current();
    if (log == nullptr)
        dxUpstreamJointAttach(joint, body1, body2);
    else
        log->attach(joint, body1, body2);
}

// Upstream lists the joints in memory that it takes from the user's allocator, if there is one, who may count
// that.
void dJointGroupEmpty(dJointGroupID group) {
    if (group == nullptr || dGetAllocHandler() != nullptr || !dxRemoveJoints(*group))
        dxUpstreamJointGroupEmpty(group);
}

}  // extern "C"
