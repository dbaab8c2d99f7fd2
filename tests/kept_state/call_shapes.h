// Arrays of the user's for meshes, convex geoms and height fields of the call test, each in two versions, and
// a class of geoms of the user's. The arrays outlive every scene.
#pragma once

#include <ode/ode.h>

namespace kept_state {

struct ConvexArrays {
    const dReal *planes;
    unsigned planeCount;
    const dReal *points;
    unsigned pointCount;
    const unsigned *polygons;
};
ConvexArrays convexArrays(int version);  // 0: a cube, 1: a longer one

dTriMeshDataID createMeshData(int version);  // 0: an octahedron, 1: a larger one
dReal *meshVertices(int version);            // 6 x 4, as dVector3; the user's own
const dTriIndex *meshIndices();              // 8 x 3
const float *meshVerticesSingle();

dHeightfieldDataID createHeights(int version);  // 0: bumps, 1: higher ones
double *heightSamples(int version);             // 5 x 5, not copied

int customClass();  // a sphere of the program's
int testedClass();  // the same, with a box test
dGeomID createCustom(dSpaceID space, dReal radius, int geomClass);
dGeomClass customClassFunctions();

}  // namespace kept_state
