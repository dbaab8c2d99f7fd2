/* Linker names of upstream's functions around its table of colliders (the public ones are in
 * ode_mt/api/user_classes.cpp) and around what decides whether geoms may meet (ode_mt/api/geom_filters.cpp, geom_switches.cpp). */
#pragma once

#include <ode/collision.h>

extern "C" {
int dCollide(dGeomID, dGeomID, int, dContactGeom *, int) __asm__("dxUpstreamCollide");
int dCreateGeomClass(const dGeomClass *) __asm__("dxUpstreamCreateGeomClass");
void dSetColliderOverride(int, int, dColliderFn *) __asm__("dxUpstreamSetColliderOverride");
void dGeomSetBody(dGeomID, dBodyID) __asm__("dxUpstreamGeomSetBody");
void dGeomSetCategoryBits(dGeomID, unsigned long) __asm__("dxUpstreamGeomSetCategoryBits");
void dGeomSetCollideBits(dGeomID, unsigned long) __asm__("dxUpstreamGeomSetCollideBits");
void dGeomEnable(dGeomID) __asm__("dxUpstreamGeomEnable");
void dGeomDisable(dGeomID) __asm__("dxUpstreamGeomDisable");
}
