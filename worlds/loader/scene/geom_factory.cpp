#include "loader/scene/geom_factory.h"

namespace worlds {

namespace {

// ODE's height fields lie in x and z with y up. This rotates y to z, and z to -y: ODE's first row is
// then the one at the largest y, as the description has it.
const Quaternion yUpToZUp = Quaternion::fromRollPitchYaw(kPi / 2, 0, 0);

// How far below its lowest sample ODE still takes a height field for solid, m.
constexpr double heightFieldThickness = 1;

Quaternion rotationOf(const Shape &shape, const Pose &pose) {
    return std::holds_alternative<HeightField>(shape) ? pose.rotation * yUpToZUp : pose.rotation;
}

void placePlane(dGeomID geom, const Plane &plane, const Pose &pose) {
    const Vector3 normal = pose.rotation * plane.normal;
    dGeomPlaneSetParams(geom, toReal(normal.x), toReal(normal.y), toReal(normal.z),
                        toReal(normal.dot(pose.position)));
}

}  // namespace

dGeomID GeomFactory::createStatic(dSpaceID space, const Collision &collision, const Pose &linkPose) {
    const Pose pose = linkPose * collision.pose;
    const dGeomID geom = create(space, collision.shape);
    if (const Plane *plane = std::get_if<Plane>(&collision.shape)) {
        placePlane(geom, *plane, pose);
        return geom;
    }
    dGeomSetPosition(geom, toReal(pose.position.x), toReal(pose.position.y), toReal(pose.position.z));
    dGeomSetQuaternion(geom, OdeQuaternion(rotationOf(collision.shape, pose)).value);
    return geom;
}

dGeomID GeomFactory::createOn(dBodyID body, dSpaceID space, const Collision &collision,
                              const Vector3 &centerOfMass) {
    const dGeomID geom = create(space, collision.shape);
    dGeomSetBody(geom, body);
    const Vector3 offset = collision.pose.position - centerOfMass;
    if (offset != Vector3())
        dGeomSetOffsetPosition(geom, toReal(offset.x), toReal(offset.y), toReal(offset.z));
    if (!(collision.pose.rotation == Quaternion()))
        dGeomSetOffsetQuaternion(geom, OdeQuaternion(collision.pose.rotation).value);
    return geom;
}

dGeomID GeomFactory::create(dSpaceID space, const Shape &shape) {
    return std::visit([&](const auto &kind) { return create(space, kind); }, shape);
}

dGeomID GeomFactory::create(dSpaceID space, const Box &box) {
    return dCreateBox(space, toReal(box.size.x), toReal(box.size.y), toReal(box.size.z));
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
