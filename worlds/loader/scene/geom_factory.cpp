#include "loader/scene/geom_factory.h"

namespace worlds {

namespace {

using ignition::math::Pose3d;
using ignition::math::Quaterniond;
using ignition::math::Vector3d;

// ODE's height fields lie in x and z with y up. This rotates y to z, and z to -y: ODE's first row is
// then the one at the largest y, as the description has it.
const Quaterniond yUpToZUp(IGN_PI / 2, 0, 0);

// How far below its lowest sample ODE still takes a height field for solid, m.
constexpr double heightFieldThickness = 1;

Quaterniond rotationOf(const Shape &shape, const Pose3d &pose) {
    return std::holds_alternative<HeightField>(shape) ? pose.Rot() * yUpToZUp : pose.Rot();
}

void placePlane(dGeomID geom, const Plane &plane, const Pose3d &pose) {
    const Vector3d normal = pose.Rot() * plane.normal;
    dGeomPlaneSetParams(geom, toReal(normal.X()), toReal(normal.Y()), toReal(normal.Z()),
                        toReal(normal.Dot(pose.Pos())));
}

}  // namespace

dGeomID GeomFactory::createStatic(dSpaceID space, const Collision &collision, const Pose3d &linkPose) {
    const Pose3d pose = linkPose * collision.pose;
    const dGeomID geom = create(space, collision.shape);
    if (const Plane *plane = std::get_if<Plane>(&collision.shape)) {
        placePlane(geom, *plane, pose);
        return geom;
    }
    dGeomSetPosition(geom, toReal(pose.Pos().X()), toReal(pose.Pos().Y()), toReal(pose.Pos().Z()));
    dGeomSetQuaternion(geom, Quaternion(rotationOf(collision.shape, pose)).value);
    return geom;
}

dGeomID GeomFactory::createOn(dBodyID body, dSpaceID space, const Collision &collision,
                              const Vector3d &centerOfMass) {
    const dGeomID geom = create(space, collision.shape);
    dGeomSetBody(geom, body);
    const Vector3d offset = collision.pose.Pos() - centerOfMass;
    if (offset != Vector3d::Zero)
        dGeomSetOffsetPosition(geom, toReal(offset.X()), toReal(offset.Y()), toReal(offset.Z()));
    if (collision.pose.Rot() != Quaterniond::Identity)
        dGeomSetOffsetQuaternion(geom, Quaternion(collision.pose.Rot()).value);
    return geom;
}

dGeomID GeomFactory::create(dSpaceID space, const Shape &shape) {
    return std::visit([&](const auto &kind) { return create(space, kind); }, shape);
}

dGeomID GeomFactory::create(dSpaceID space, const Box &box) {
    return dCreateBox(space, toReal(box.size.X()), toReal(box.size.Y()), toReal(box.size.Z()));
}

dGeomID GeomFactory::create(dSpaceID space, const Sphere &sphere) {
    return dCreateSphere(space, toReal(sphere.radius));
}

dGeomID GeomFactory::create(dSpaceID space, const Cylinder &cylinder) {
    return dCreateCylinder(space, toReal(cylinder.radius), toReal(cylinder.length));
}

dGeomID GeomFactory::create(dSpaceID space, const Capsule &capsule) {
    return dCreateCapsule(space, toReal(capsule.radius), toReal(capsule.length));
}

dGeomID GeomFactory::create(dSpaceID space, const Plane &) { return dCreatePlane(space, 0, 0, 1, 0); }

dGeomID GeomFactory::create(dSpaceID space, const TriangleMesh &mesh) {
    const TriangleMesh &kept = m_meshes.emplace_back(mesh);
    const dTriMeshDataID data = m_meshData.emplace_back(dGeomTriMeshDataCreate()).get();
    constexpr int floats = 3 * sizeof(float), indices = 3 * sizeof(dTriIndex);
    dGeomTriMeshDataBuildSingle(data, kept.vertices.data(), floats,
                                static_cast<int>(kept.vertices.size() / 3), kept.triangles.data(),
                                static_cast<int>(kept.triangles.size()), indices);
    return dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
}

dGeomID GeomFactory::create(dSpaceID space, const HeightField &field) {
    const dHeightfieldDataID data = m_heightData.emplace_back(dGeomHeightfieldDataCreate()).get();
    constexpr int copy = 1, wrap = 0;
    dGeomHeightfieldDataBuildDouble(data, field.heights.data(), copy, toReal(field.width),
                                    toReal(field.depth), field.columns, field.rows, 1, 0,
                                    toReal(heightFieldThickness), wrap);
    constexpr int placeable = 1;
    return dCreateHeightfield(space, data, placeable);
}

}  // namespace worlds
