// A scene of one world, one root space and one group of contact joints: what most scenes are.
//
// SI units, z up, gravity 9.81 m/s². A scene derives from it, builds its bodies in its constructor
// with the add functions and drives them in control(). Everything that is added is in the
// inventory. Static geoms carry category bits that keep them from being tested with one another.
#pragma once

#include "scenes/polyhedron.h"
#include "scenes/scene_options.h"
#include "scenes/vector3.h"

#include <memory>
#include <vector>

namespace scenes {

class WorldScene : public Scene {
public:
    // Contacts asked of dCollide for one pair of geoms. ODE's box-box collider reports at most 8;
    // a wheel or limb on a mesh is held well by as many.
    static constexpr int kMaxContacts = 8;

    static constexpr unsigned long kStaticCategory = 1, kDynamicCategory = 2;

    ~WorldScene() override;

    void collide() override;
    void step() override;
    void finish() override;

    dWorldID world() const { return m_world; }
    dSpaceID space() const { return m_space; }

    // Bodies with one geom. Axes of capsules and cylinders are unit vectors in world coordinates
    // and become the body's own z axis. A capsule's length goes without its caps.
    dBodyID addBox(const Vector3 &position, const Vector3 &sides, dReal mass);
    dBodyID addSphere(const Vector3 &position, dReal radius, dReal mass);
    dBodyID addCapsule(const Vector3 &position, const Vector3 &axis, dReal radius, dReal length, dReal mass);
    dBodyID addCylinder(const Vector3 &position, const Vector3 &axis, dReal radius, dReal length, dReal mass);
    dBodyID addConvex(const Vector3 &position, const std::shared_ptr<Polyhedron> &shape, dReal mass);

    // Geoms without a body.
    dGeomID addGround();  // the plane z = 0
    dGeomID addStaticBox(const Vector3 &position, const Vector3 &sides, dReal yaw = 0);
    dGeomID addStaticSphere(const Vector3 &position, dReal radius);
    dGeomID addStaticCapsule(const Vector3 &position, dReal radius, dReal length);
    dGeomID addStaticCylinder(const Vector3 &position, dReal radius, dReal length);
    void addWalls(dReal width, dReal bottom, dReal top);  // four, around a square with a corner at the origin

    // Joints; `second` may be null for the static world. Anchors and axes in world coordinates.
    dJointID addBall(dBodyID first, dBodyID second, const Vector3 &anchor);
    dJointID addFixed(dBodyID first, dBodyID second);
    dJointID addHinge(dBodyID first, dBodyID second, const Vector3 &anchor, const Vector3 &axis);
    dJointID addUniversal(dBodyID first, dBodyID second, const Vector3 &anchor, const Vector3 &axis1,
                          const Vector3 &axis2);
    dJointID addHinge2(dBodyID first, dBodyID second, const Vector3 &anchor, const Vector3 &axis1,
                       const Vector3 &axis2);
    dJointID addEulerMotor(dBodyID first, dBodyID second, const Vector3 &axis1, const Vector3 &axis3);

    // For objects made elsewhere: enters them in the inventory and sets the geom's category.
    dBodyID add(dBodyID body);
    dGeomID add(dGeomID geom);
    dJointID add(dJointID joint);

    // Keeps data alive that a geom points to (meshes, height fields) until the geoms are gone.
    void keep(std::shared_ptr<void> data) { m_kept.push_back(std::move(data)); }

protected:
    WorldScene(const SceneOptions &options, dReal stepSize);

    // Returns the surface of every contact of the pair. The default is m_surface.
    virtual dSurfaceParameters surface(dGeomID, dGeomID) const { return m_surface; }

    // What Box3D's benchmark has: 1/60 s; gravity 10 m/s² and friction 0.6.
    static constexpr dReal kBox3DStepSize = REAL(1.0) / 60;  // s
    void useBox3DDefaults();

    dSurfaceParameters m_surface{};  // Coulomb pyramid with friction 0.8, slightly soft

private:
    static void nearCallback(void *scene, dGeomID o1, dGeomID o2);
    void meet(dGeomID o1, dGeomID o2);
    dBodyID addBody(const Vector3 &position, const dMass &mass, dGeomID geom);

    Stepper m_stepper;
    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_contactGroup;
    std::vector<std::shared_ptr<void>> m_kept;
};

}  // namespace scenes
