/* Linker names of upstream's functions that make, change or destroy the data of height fields; the public ones are in
 * ode_mt/api/height_fields.cpp. */
#pragma once

#include <ode/collision.h>

extern "C" {
dHeightfieldDataID dGeomHeightfieldDataCreate(void) __asm__("dxUpstreamHeightfieldDataCreate");
void dGeomHeightfieldDataBuildCallback(dHeightfieldDataID, void *, dHeightfieldGetHeight *, dReal, dReal, int, int,
                                       dReal, dReal, dReal, int) __asm__("dxUpstreamHeightfieldDataBuildCallback");
void dGeomHeightfieldDataBuildByte(dHeightfieldDataID, const unsigned char *, int, dReal, dReal, int, int, dReal, dReal,
                                   dReal, int) __asm__("dxUpstreamHeightfieldDataBuildByte");
void dGeomHeightfieldDataBuildShort(dHeightfieldDataID, const short *, int, dReal, dReal, int, int, dReal, dReal, dReal,
                                    int) __asm__("dxUpstreamHeightfieldDataBuildShort");
void dGeomHeightfieldDataBuildSingle(dHeightfieldDataID, const float *, int, dReal, dReal, int, int, dReal, dReal, dReal,
                                     int) __asm__("dxUpstreamHeightfieldDataBuildSingle");
void dGeomHeightfieldDataBuildDouble(dHeightfieldDataID, const double *, int, dReal, dReal, int, int, dReal, dReal,
                                     dReal, int) __asm__("dxUpstreamHeightfieldDataBuildDouble");
void dGeomHeightfieldDataSetBounds(dHeightfieldDataID, dReal, dReal) __asm__("dxUpstreamHeightfieldDataSetBounds");
void dGeomHeightfieldDataDestroy(dHeightfieldDataID) __asm__("dxUpstreamHeightfieldDataDestroy");
}
