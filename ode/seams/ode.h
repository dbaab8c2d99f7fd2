/* Linker names of upstream's functions after which a threading implementation may be freed; the public
 * ones are in ode_mt/api/world_threading.cpp. */
#pragma once

#include <ode/objects.h>

extern "C" {
void dWorldDestroy(dWorldID) __asm__("dxUpstreamWorldDestroy");
void dWorldSetStepThreadingImplementation(dWorldID, const dThreadingFunctionsInfo *, dThreadingImplementationID)
    __asm__("dxUpstreamWorldSetStepThreadingImplementation");
}
