// Functions of joints (ode/objects.h) that move a body to and fro while they compute anchors: its position comes back rounded,
// and contacts that were computed from it hear of that (collision/dxSilentChanges.h). Upstream's own functions are renamed by
// the seam ode/seams/joint_offsets.h.
#include <ode/objects.h>

#include "collision/dxSilentChanges.h"

namespace {

using SetOffset = void(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz);

}  // namespace

extern "C" {
SetOffset dxUpstreamJointSetPistonAnchorOffset, dxUpstreamJointSetPUAnchorDelta, dxUpstreamJointSetPUAnchorOffset;

void dJointSetPistonAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz) {
    dxSilentChanges::add();
    dxUpstreamJointSetPistonAnchorOffset(joint, x, y, z, dx, dy, dz);
}

void dJointSetPUAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz) {
    dxSilentChanges::add();
    dxUpstreamJointSetPUAnchorDelta(joint, x, y, z, dx, dy, dz);
}

void dJointSetPUAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz) {
    dxSilentChanges::add();
    dxUpstreamJointSetPUAnchorOffset(joint, x, y, z, dx, dy, dz);
}

}  // extern "C"
