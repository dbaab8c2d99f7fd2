// Between the types of ignition::math and ODE, and owners of ODE objects.
#pragma once

#include <ode/ode.h>
#include <ignition/math/Pose3.hh>

#include <cmath>
#include <memory>

namespace worlds {

inline dReal toReal(double number) {
    return std::isinf(number) ? std::copysign(static_cast<dReal>(dInfinity), static_cast<dReal>(number))
                              : static_cast<dReal>(number);
}

struct Quaternion {
    dQuaternion value;
    explicit Quaternion(const ignition::math::Quaterniond &q)
        : value{toReal(q.W()), toReal(q.X()), toReal(q.Y()), toReal(q.Z())} {}
};

struct WorldDeleter {
    void operator()(dWorldID world) const { dWorldDestroy(world); }
};
struct SpaceDeleter {
    void operator()(dSpaceID space) const { dSpaceDestroy(space); }
};
struct JointGroupDeleter {
    void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
};
struct MeshDataDeleter {
    void operator()(dTriMeshDataID data) const { dGeomTriMeshDataDestroy(data); }
};
struct HeightDataDeleter {
    void operator()(dHeightfieldDataID data) const { dGeomHeightfieldDataDestroy(data); }
};

template <class Handle, class Deleter>
using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Deleter>;

using WorldOwner = Owner<dWorldID, WorldDeleter>;
using SpaceOwner = Owner<dSpaceID, SpaceDeleter>;
using JointGroupOwner = Owner<dJointGroupID, JointGroupDeleter>;
using MeshDataOwner = Owner<dTriMeshDataID, MeshDataDeleter>;
using HeightDataOwner = Owner<dHeightfieldDataID, HeightDataDeleter>;

}  // namespace worlds
