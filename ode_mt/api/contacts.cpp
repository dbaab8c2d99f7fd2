// Contact joints (ode/objects.h). Where callbacks run on several threads, they are put into their lists later
// (collision/dxContactLog.h).
#include <ode/objects.h>

#include "collision/dxContactLog.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/ode.h.
dJointID dxUpstreamJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact);
void dxUpstreamJointAttach(dJointID joint, dBodyID body1, dBodyID body2);

dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact) {
    dxContactLog *const log = dxContactLog::current();
    return log == nullptr ? dxUpstreamJointCreateContact(world, group, contact) : log->create(world, group, contact);
}

void dJointAttach(dJointID joint, dBodyID body1, dBodyID body2) {
    dxContactLog *const log = dxContactLog::current();
    if (log == nullptr)
        dxUpstreamJointAttach(joint, body1, body2);
    else
        log->attach(joint, body1, body2);
}

}  // extern "C"
