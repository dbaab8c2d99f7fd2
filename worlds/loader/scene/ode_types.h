// Between our types and those of ODE, and owners of ODE objects.
#pragma once

#include "loader/description/geometry.h"

#include <ode/ode.h>

#include <cmath>
#include <memory>

namespace worlds {

inline dReal toReal(double number) {
    return std::isinf(number) ? std::copysign(static_cast<dReal>(dInfinity), static_cast<dReal>(number))
                              : static_cast<dReal>(number);
}

struct OdeQuaternion {
    dQuaternion value;
    explicit OdeQuaternion(const Quaternion &q) : value{toReal(q.w), toReal(q.x), toReal(q.y), toReal(q.z)} {}
};
inline Quaternion toQuaternion(const dReal *q) { return {q[0], q[1], q[2], q[3]}; }
inline Vector3 toVector(const dReal *v) { return {v[0], v[1], v[2]}; }

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
