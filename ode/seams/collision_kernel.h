/* Linker names of upstream's functions around its table of colliders; the public ones are in
 * ode_mt/api/user_classes.cpp. */
#pragma once

#include <ode/collision.h>

extern "C" {
int dCollide(dGeomID, dGeomID, int, dContactGeom *, int) __asm__("dxUpstreamCollide");
int dCreateGeomClass(const dGeomClass *) __asm__("dxUpstreamCreateGeomClass");
void dSetColliderOverride(int, int, dColliderFn *) __asm__("dxUpstreamSetColliderOverride");
}
