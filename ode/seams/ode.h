/* Linker names of upstream's functions after which a threading implementation may be freed (the public ones
 * are in ode_mt/api/world_threading.cpp) and of those that make and remove contact joints (ode_mt/api/contacts.cpp). */
#pragma once

#include <ode/contact.h>
#include <ode/objects.h>

extern "C" {
void dWorldDestroy(dWorldID) __asm__("dxUpstreamWorldDestroy");
void dWorldSetStepThreadingImplementation(dWorldID, const dThreadingFunctionsInfo *, dThreadingImplementationID)
    __asm__("dxUpstreamWorldSetStepThreadingImplementation");
dJointID dJointCreateContact(dWorldID, dJointGroupID, const dContact *) __asm__("dxUpstreamJointCreateContact");
void dJointAttach(dJointID, dBodyID, dBodyID) __asm__("dxUpstreamJointAttach");
void dJointGroupEmpty(dJointGroupID) __asm__("dxUpstreamJointGroupEmpty");
}
