/* Linker names of upstream's functions that make spaces of all kinds, around the hash space and of the entry to a
 * frame's collisions; the public ones are in ode_mt/api/spaces.cpp. */
#pragma once

#include <ode/collision_space.h>

extern "C" {
dSpaceID dSimpleSpaceCreate(dSpaceID) __asm__("dxUpstreamSimpleSpaceCreate");
dSpaceID dHashSpaceCreate(dSpaceID) __asm__("dxUpstreamHashSpaceCreate");
dSpaceID dQuadTreeSpaceCreate(dSpaceID, const dVector3, const dVector3, int) __asm__("dxUpstreamQuadTreeSpaceCreate");
dSpaceID dSweepAndPruneSpaceCreate(dSpaceID, int) __asm__("dxUpstreamSweepAndPruneSpaceCreate");
void dHashSpaceSetLevels(dSpaceID, int, int) __asm__("dxUpstreamHashSpaceSetLevels");
void dHashSpaceGetLevels(dSpaceID, int *, int *) __asm__("dxUpstreamHashSpaceGetLevels");
void dSpaceCollide(dSpaceID, void *, dNearCallback *) __asm__("dxUpstreamSpaceCollide");
}
