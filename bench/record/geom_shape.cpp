#include "record/geom_shape.h"

#include <algorithm>
#include <limits>

namespace record {

namespace {

constexpr int kMaxTriangles = 400;  // of a mesh that is recorded as such

std::vector<double> boundsOf(const std::vector<Triangle> &triangles) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<double> bounds = {kInfinity, kInfinity, kInfinity, -kInfinity, -kInfinity, -kInfinity};
    for (const Triangle &triangle : triangles) {
        for (const Vector &corner : triangle) {
            for (std::size_t i = 0; i < 3; ++i) {
                bounds[i] = std::min(bounds[i], corner[i]);
                bounds[3 + i] = std::max(bounds[3 + i], corner[i]);
            }
        }
    }
    return bounds;
}

// ODE gives corners in the world's axes.
Vector toGeom(dGeomID geom, const dVector3 point) {
    const dReal *position = dGeomGetPosition(geom), *rotation = dGeomGetRotation(geom);
    Vector local{};
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            local[column] += static_cast<double>(rotation[4 * row + column] * (point[row] - position[row]));
    return local;
}

Shape meshOf(dGeomID geom) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < dGeomTriMeshGetTriangleCount(geom); ++i) {
        dVector3 a, b, c;
        dGeomTriMeshGetTriangle(geom, i, &a, &b, &c);
        triangles.push_back({toGeom(geom, a), toGeom(geom, b), toGeom(geom, c)});
    }
    const std::vector<double> bounds = boundsOf(triangles);
    if (triangles.size() > kMaxTriangles) triangles.clear();
    return {"mesh", bounds, triangles};
}

Shape edgesOfBounds(dGeomID geom) {
    dReal box[6];  // least x, most x, least y, …
    dGeomGetAABB(geom, box);
    return {"bounds", {box[1] - box[0], box[3] - box[2], box[5] - box[4]}, {}};
}

Pose middleOfBounds(dGeomID geom) {
    dReal box[6];
    dGeomGetAABB(geom, box);
    return {{(box[0] + box[1]) / 2, (box[2] + box[3]) / 2, (box[4] + box[5]) / 2}, {1, 0, 0, 0}};
}

Shape boxOf(dGeomID geom) {
    dVector3 edges;
    dGeomBoxGetLengths(geom, edges);
    return {"box", {edges[0], edges[1], edges[2]}, {}};
}

Shape planeOf(dGeomID geom) {
    dVector4 plane;
    dGeomPlaneGetParams(geom, plane);
    return {"plane", {plane[0], plane[1], plane[2], plane[3]}, {}};
}

template <class GetParams>
Shape roundShape(const char *kind, dGeomID geom, GetParams getParams) {
    dReal radius = 0, length = 0;
    getParams(geom, &radius, &length);
    return {kind, {radius, length}, {}};
}

Pose pose(const dReal *position, const dReal *quaternion) {
    Pose pose;
    std::copy_n(position, 3, pose.position.begin());
    std::copy_n(quaternion, 4, pose.quaternion.begin());
    return pose;
}

}  // namespace

Shape shapeOf(dGeomID geom) {
    switch (dGeomGetClass(geom)) {
        case dBoxClass:
            return boxOf(geom);
        case dSphereClass:
            return {"sphere", {dGeomSphereGetRadius(geom)}, {}};
        case dCapsuleClass:
            return roundShape("capsule", geom, dGeomCapsuleGetParams);
        case dCylinderClass:
            return roundShape("cylinder", geom, dGeomCylinderGetParams);
        case dPlaneClass:
            return planeOf(geom);
        case dTriMeshClass:
            return meshOf(geom);
        default:
            return edgesOfBounds(geom);
    }
}

Pose poseOf(dGeomID geom) {
    switch (dGeomGetClass(geom)) {
        case dBoxClass:
        case dSphereClass:
        case dCapsuleClass:
        case dCylinderClass:
        case dTriMeshClass: {
            dQuaternion quaternion;
            dGeomGetQuaternion(geom, quaternion);
            return pose(dGeomGetPosition(geom), quaternion);
        }
        case dPlaneClass:
            return {};
        default:  // may have no pose of its own
            return middleOfBounds(geom);
    }
}

Velocity velocityOf(dBodyID body) {
    Velocity velocity;
    std::copy_n(dBodyGetLinearVel(body), 3, velocity.linear.begin());
    std::copy_n(dBodyGetAngularVel(body), 3, velocity.angular.begin());
    return velocity;
}

Pose poseOf(dBodyID body) { return pose(dBodyGetPosition(body), dBodyGetQuaternion(body)); }

}  // namespace record
