// Geoms from collision shapes. Owns the data that meshes and height fields point to, and has to
// outlive the geoms.
#pragma once

#include "loader/description/world_description.h"
#include "loader/scene/ode_types.h"

#include <deque>
#include <vector>

namespace worlds {

class GeomFactory {
public:
    // Makes a geom that does not move, of a link at `linkPose` in the world.
    dGeomID createStatic(dSpaceID space, const Collision &collision, const Pose &linkPose);

    // A geom that moves with a body, whose origin is the link's centre of mass.
    dGeomID createOn(dBodyID body, dSpaceID space, const Collision &collision,
                     const Vector3 &centerOfMass);

private:
    dGeomID create(dSpaceID space, const Shape &shape);
    static dGeomID create(dSpaceID space, const Box &box);
    static dGeomID create(dSpaceID space, const Sphere &sphere);
    static dGeomID create(dSpaceID space, const Cylinder &cylinder);
    static dGeomID create(dSpaceID space, const Capsule &capsule);
    static dGeomID create(dSpaceID space, const Plane &plane);
    dGeomID create(dSpaceID space, const TriangleMesh &mesh);
    dGeomID create(dSpaceID space, const HeightField &field);

    std::deque<TriangleMesh> m_meshes;
    std::vector<MeshDataOwner> m_meshData;
    std::vector<HeightDataOwner> m_heightData;
};

}  // namespace worlds
