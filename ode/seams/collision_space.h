/* Linker names of upstream's functions around the simple and the hash space; the public ones are in
 * ode_mt/api/spaces.cpp. */
#pragma once

#include <ode/collision_space.h>

extern "C" {
dSpaceID dSimpleSpaceCreate(dSpaceID) __asm__("dxUpstreamSimpleSpaceCreate");
dSpaceID dHashSpaceCreate(dSpaceID) __asm__("dxUpstreamHashSpaceCreate");
void dHashSpaceSetLevels(dSpaceID, int, int) __asm__("dxUpstreamHashSpaceSetLevels");
void dHashSpaceGetLevels(dSpaceID, int *, int *) __asm__("dxUpstreamHashSpaceGetLevels");
}
