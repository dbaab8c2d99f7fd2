// Geoms of every class that has a volume, for scenarios that collide every two.
#pragma once

#include <ode/ode.h>

namespace exactness {

enum class Shape { Sphere, Box, Capsule, Cylinder, Convex, Mesh };
constexpr Shape allShapes[] = {Shape::Sphere,   Shape::Box,    Shape::Capsule,
                               Shape::Cylinder, Shape::Convex, Shape::Mesh};

// About half a metre in size.
dGeomID createShape(dSpaceID space, Shape shape);

// Convex geoms collide only with meshes that know the angles between their faces.
void prepareForConvex(dTriMeshDataID data);

// The mesh of createShape: an octahedron.
dTriMeshDataID octahedronMesh();

}  // namespace exactness
