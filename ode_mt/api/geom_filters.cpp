// What decides, beside boxes, whether two geoms may meet (ode/collision.h): their body and their bits. The
// space that a geom is in keeps its pairs and has to hear of a change.
#include <ode/collision.h>

#include "collision/dxOrderedSpace.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/collision_kernel.h.
void dxUpstreamGeomSetBody(dGeomID geom, dBodyID body);
void dxUpstreamGeomSetCategoryBits(dGeomID geom, unsigned long bits);
void dxUpstreamGeomSetCollideBits(dGeomID geom, unsigned long bits);
}

namespace {

// And the spaces around it: a space that holds a geom with a body is dynamic.
void tellSpaces(dGeomID geom) {
    for (; geom != nullptr; geom = geom->parent_space)
        if (dxOrderedSpace *const space = dxOrderedSpace::of(geom)) space->filtersChanged(geom);
}

}  // namespace

extern "C" {

void dGeomSetBody(dGeomID geom, dBodyID body) {
    dxUpstreamGeomSetBody(geom, body);
    tellSpaces(geom);
}

void dGeomSetCategoryBits(dGeomID geom, unsigned long bits) {
    dxUpstreamGeomSetCategoryBits(geom, bits);
    tellSpaces(geom);
}

void dGeomSetCollideBits(dGeomID geom, unsigned long bits) {
    dxUpstreamGeomSetCollideBits(geom, bits);
    tellSpaces(geom);
}

}  // extern "C"
