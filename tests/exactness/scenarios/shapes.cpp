#include "shapes.h"

namespace exactness {

namespace {

constexpr dReal r = 0.3;  // m

constexpr int cornerCount = 6, faceCount = 8;
const dReal corners[cornerCount * 3] = {r, 0, 0, -r, 0, 0, 0, r, 0, 0, -r, 0, 0, 0, r, 0, 0, -r};
const dTriIndex faces[faceCount * 3] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                        2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

// A wedge-like box: faces of a cuboid in the form that ODE's convex geoms want them.
constexpr dReal h = 0.25;  // m, half an edge
const dReal cuboidPlanes[6 * 4] = {1, 0, 0, h, 0, 1, 0, h, 0, 0, 1, h, -1, 0, 0, h, 0, -1, 0, h, 0, 0, -1, h};
const dReal cuboidPoints[8 * 3] = {h, h, h,  -h, h, h,  h, -h, h,  -h, -h, h,
                                   h, h, -h, -h, h, -h, h, -h, -h, -h, -h, -h};
const unsigned cuboidPolygons[] = {4, 0, 2, 6, 4, 4, 1, 0, 4, 5, 4, 0, 1, 3, 2,
                                   4, 3, 1, 5, 7, 4, 2, 3, 7, 6, 4, 5, 4, 6, 7};

}  // namespace

void prepareForConvex(dTriMeshDataID data) {
    dGeomTriMeshDataPreprocess2(data, 1U << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
}

// ODE frees nothing of it but the data object, which lives as long as the program: its vertices are
// static, and every scene of one process uses the same.
dTriMeshDataID octahedronMesh() {
    static const dTriMeshDataID data = [] {
        const dTriMeshDataID built = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(built, corners, 3 * sizeof(dReal), cornerCount, faces, faceCount * 3,
                                    3 * sizeof(dTriIndex));
        prepareForConvex(built);
        return built;
    }();
    return data;
}

dGeomID createShape(dSpaceID space, Shape shape) {
    switch (shape) {
        case Shape::Sphere:
            return dCreateSphere(space, 0.25);
        case Shape::Box:
            return dCreateBox(space, 0.5, 0.4, 0.45);
        case Shape::Capsule:
            return dCreateCapsule(space, 0.15, 0.3);
        case Shape::Cylinder:
            return dCreateCylinder(space, 0.2, 0.4);
        case Shape::Convex:
            return dCreateConvex(space, cuboidPlanes, 6, cuboidPoints, 8, cuboidPolygons);
        case Shape::Mesh:
            return dCreateTriMesh(space, octahedronMesh(), nullptr, nullptr, nullptr);
    }
    return nullptr;
}

}  // namespace exactness
