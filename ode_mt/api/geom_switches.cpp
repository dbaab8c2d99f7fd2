// dGeomEnable and dGeomDisable (ode/collision.h): upstream's hash space asks which geoms are enabled before the first
// callback of a call, and callbacks may switch them.
#include <ode/collision.h>

#include "collision/dxOrderedSpace.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/collision_kernel.h.
void dxUpstreamGeomEnable(dGeomID geom);
void dxUpstreamGeomDisable(dGeomID geom);
}

namespace {

// Upstream answers a NULL.
void tellSpace(dGeomID geom) {
    dxOrderedSpace *const space = geom != nullptr ? dxOrderedSpace::of(geom) : nullptr;
    if (space != nullptr) space->enabledChanges(geom);
}

}  // namespace

extern "C" {

void dGeomEnable(dGeomID geom) {
    tellSpace(geom);
    dxUpstreamGeomEnable(geom);
}

void dGeomDisable(dGeomID geom) {
    tellSpace(geom);
    dxUpstreamGeomDisable(geom);
}

}  // extern "C"
