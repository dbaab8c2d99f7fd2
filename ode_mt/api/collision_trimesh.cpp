// Functions of ode/collision_trimesh.h: what happens to a mesh, or to its data, without its space being told.
#include <ode/collision.h>

#include "collision/pairs/dxUnnoticedChanges.h"
#include "config.h"
#include "collision_kernel.h"
#include "seams/upstream.h"

extern "C" {

// A geom that is dirty already waits to be cleaned, or has been counted.
void dGeomTriMeshSetData(dGeomID geom, dTriMeshDataID data) {
    const bool isUnnoticed =
        geom != nullptr && geom->parent_space != nullptr && (geom->gflags & GEOM_DIRTY) == 0;
    if (isUnnoticed) dxMissedNotifications.add();
    dxUpstreamGeomTriMeshSetData(geom, data);
}

// Geoms may have it still, which the program then does not collide any more.
void dGeomTriMeshDataDestroy(dTriMeshDataID data) {
    dxSilentChanges.add();
    dxUpstreamGeomTriMeshDataDestroy(data);
}

}  // extern "C"
