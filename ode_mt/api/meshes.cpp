// Meshes (ode/collision_trimesh.h): what happens to one without its space being told.
#include <ode/collision.h>

#include "collision/dxMissedNotifications.h"
#include "config.h"
#include "collision_kernel.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/collision_trimesh.h.
void dxUpstreamGeomTriMeshSetData(dGeomID geom, dTriMeshDataID data);

// A geom that is dirty already waits to be cleaned, or has been counted.
void dGeomTriMeshSetData(dGeomID geom, dTriMeshDataID data) {
    const bool isUnnoticed =
        geom != nullptr && geom->parent_space != nullptr && (geom->gflags & GEOM_DIRTY) == 0;
    if (isUnnoticed) dxMissedNotifications::add();
    dxUpstreamGeomTriMeshSetData(geom, data);
}

}  // extern "C"
