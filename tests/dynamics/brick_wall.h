// A wall of bricks on a plane or on a moving floor, hard or soft, whose contacts are made anew before each step.
#pragma once

#include <ode/ode.h>

#include <cstring>
#include <vector>

class BrickWall {
public:
    struct Shape {
        int side = 6;
        dReal mu = dReal(0.5);
        bool hasApproximation = true;  // dContactApprox1
        dReal cfm = dReal(1e-5);
        bool hasMovingFloor = false;
    };

    explicit BrickWall(const Shape &shape)
        : m_shape(shape), m_world(dWorldCreate()), m_space(dHashSpaceCreate(nullptr)), m_contacts(dJointGroupCreate(0)) {
        dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
        dWorldSetCFM(m_world, shape.cfm);
        if (shape.hasMovingFloor)
            addFloor();
        else
            dCreatePlane(m_space, 0, 0, 1, 0);
        for (int course = 0; course < shape.side; ++course)
            for (int i = 0; i < shape.side; ++i) addBrick(dReal(i + 0.5 * (course % 2)) * dReal(0.241), (course + dReal(0.5)) * dReal(0.07));
    }
    ~BrickWall() {
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }
    BrickWall(const BrickWall &) = delete;
    BrickWall &operator=(const BrickWall &) = delete;

    dWorldID world() const { return m_world; }
    const std::vector<dBodyID> &bricks() const { return m_bricks; }
    std::size_t contacts() const { return m_count; }

    void collide() {
        m_count = 0;
        dSpaceCollide(m_space, this, [](void *self, dGeomID a, dGeomID b) { static_cast<BrickWall *>(self)->touch(a, b); });
    }

    void step() {
        dWorldStep(m_world, dReal(0.01));
        dJointGroupEmpty(m_contacts);
    }

    // Of each brick: linear and angular.
    std::vector<dReal> velocities() const {
        std::vector<dReal> all;
        for (const dBodyID brick : m_bricks)
            for (const dReal *velocity : {dBodyGetLinearVel(brick), dBodyGetAngularVel(brick)}) all.insert(all.end(), velocity, velocity + 3);
        return all;
    }

private:
    void addFloor() {
        const dBodyID floor = dBodyCreate(m_world);
        dBodySetKinematic(floor);
        dBodySetPosition(floor, 0, 0, dReal(-0.5));
        dBodySetLinearVel(floor, dReal(0.3), 0, 0);
        dGeomSetBody(dCreateBox(m_space, 20, 20, 1), floor);
    }

    void addBrick(dReal x, dReal z) {
        const dBodyID body = dBodyCreate(m_world);
        dMass mass;
        dMassSetBoxTotal(&mass, dReal(3.3), dReal(0.24), dReal(0.115), dReal(0.071));
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, 0, z);
        dBodySetLinearVel(body, dReal(0.1) * x, 0, -z);
        dGeomSetBody(dCreateBox(m_space, dReal(0.24), dReal(0.115), dReal(0.071)), body);
        m_bricks.push_back(body);
    }

    void touch(dGeomID a, dGeomID b) {
        dContact contacts[8];
        const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            dSurfaceParameters &surface = contacts[i].surface;
            std::memset(&surface, 0, sizeof surface);
            surface.mode = m_shape.hasApproximation ? dContactApprox1 : 0;
            surface.mu = m_shape.mu;
            dJointAttach(dJointCreateContact(m_world, m_contacts, contacts + i), dGeomGetBody(a), dGeomGetBody(b));
            ++m_count;
        }
    }

    const Shape m_shape;
    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_contacts;
    std::vector<dBodyID> m_bricks;
    std::size_t m_count = 0;
};
