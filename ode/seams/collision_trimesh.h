/* Linker name of upstream's function that gives a mesh other data; the public one is in ode_mt/api/meshes.cpp. */
#pragma once

#include <ode/collision.h>

extern "C" {
void dGeomTriMeshSetData(dGeomID, dTriMeshDataID) __asm__("dxUpstreamGeomTriMeshSetData");
}
