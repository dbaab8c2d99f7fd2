/* Linker name of upstream's function that destroys the data of meshes; the public one is in ode_mt/api/meshes.cpp. */
#pragma once

#include <ode/collision.h>

extern "C" {
void dGeomTriMeshDataDestroy(dTriMeshDataID) __asm__("dxUpstreamGeomTriMeshDataDestroy");
}
