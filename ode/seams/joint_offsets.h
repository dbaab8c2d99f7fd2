/* Linker names of upstream's functions that move a body to and fro; the public ones are in ode_mt/api/joint_offsets.cpp. */
#pragma once

#include <ode/objects.h>

extern "C" {
void dJointSetPistonAnchorOffset(dJointID, dReal, dReal, dReal, dReal, dReal, dReal) __asm__("dxUpstreamJointSetPistonAnchorOffset");
void dJointSetPUAnchorDelta(dJointID, dReal, dReal, dReal, dReal, dReal, dReal) __asm__("dxUpstreamJointSetPUAnchorDelta");
void dJointSetPUAnchorOffset(dJointID, dReal, dReal, dReal, dReal, dReal, dReal) __asm__("dxUpstreamJointSetPUAnchorOffset");
}
