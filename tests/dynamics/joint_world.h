// Bodies that ball joints connect: stars, wheels, chains and nets, which hang or fall, and turn.
#pragma once

#include <ode/ode.h>

#include <cmath>
#include <vector>

#include "body_velocities.h"

class JointWorld {
public:
    explicit JointWorld(const char *solver = "exact") : m_world(dWorldCreate()) {
        dWorldSetGravity(m_world, 0, 0, -10);
        dODE_MT_SetSolver(m_world, solver);
    }
    ~JointWorld() { dWorldDestroy(m_world); }
    JointWorld(const JointWorld &) = delete;
    JointWorld &operator=(const JointWorld &) = delete;

    dWorldID world() const { return m_world; }
    const std::vector<dBodyID> &bodies() const { return m_bodies; }

    // `rays` bodies around a hub, the first body.
    void addStar(unsigned rays) {
        const dBodyID hub = addBody(0, 0, 0);
        for (unsigned i = 0; i < rays; ++i) connect(addBody(3 * std::cos(dReal(i)), 3 * std::sin(dReal(i)), dReal(0.1) * i), hub);
    }

    // A star whose rays are neighbours.
    void addWheel(unsigned rays) {
        const std::size_t first = m_bodies.size() + 1;
        addStar(rays);
        for (unsigned i = 0; i < rays; ++i) connect(m_bodies[first + i], m_bodies[first + (i + 1) % rays]);
    }

    // Hangs.
    void addChain(unsigned links) {
        for (unsigned i = 0; i < links; ++i) {
            const dBodyID last = i > 0 ? m_bodies.back() : nullptr;
            connect(addBody(i, std::sin(dReal(i)), std::cos(dReal(i))), last);
        }
    }

    // Falls.
    // On request with a few hinges, fewer than the net has freedoms.
    void addNet(unsigned side, bool hasHinges = false) {
        const std::size_t first = m_bodies.size();
        for (unsigned i = 0; i < side * side; ++i) {
            const dBodyID knot = addBody(i % side, i / side, std::sin(dReal(i)));
            const bool isHinge = hasHinges && i % 40 == 39;
            if (i % side > 0) connect(knot, m_bodies[first + i - 1], isHinge ? dJointCreateHinge : dJointCreateBall);
            if (i >= side) connect(knot, m_bodies[first + i - side]);
        }
    }

    // All bodies at once: bodies that fall together.
    void push(dReal velocity) {
        for (const dBodyID body : m_bodies) dBodySetLinearVel(body, 0, 0, velocity);
    }

    std::vector<dReal> velocities() const { return velocitiesOf(m_bodies); }

private:
    dBodyID addBody(dReal x, dReal y, dReal z) {
        m_bodies.push_back(dBodyCreate(m_world));
        dMass mass;
        dMassSetBoxTotal(&mass, 1, dReal(0.6), dReal(0.4), dReal(0.5));
        dBodySetMass(m_bodies.back(), &mass);
        dBodySetPosition(m_bodies.back(), x, y, z);
        dBodySetAngularVel(m_bodies.back(), dReal(0.1), 0, 0);
        return m_bodies.back();
    }

    // In the middle between both; no other body: above.
    void connect(dBodyID body, dBodyID other, decltype(&dJointCreateBall) create = dJointCreateBall) {
        const dReal *const here = dBodyGetPosition(body), *const there = other != nullptr ? dBodyGetPosition(other) : here;
        const dReal anchor[] = {(here[0] + there[0]) / 2, (here[1] + there[1]) / 2, (here[2] + there[2]) / 2 + (other == nullptr)};
        const dJointID joint = create(m_world, nullptr);
        dJointAttach(joint, body, other);
        const auto setAnchor = dJointGetType(joint) == dJointTypeHinge ? dJointSetHingeAnchor : dJointSetBallAnchor;
        setAnchor(joint, anchor[0], anchor[1], anchor[2]);
    }

    const dWorldID m_world;
    std::vector<dBodyID> m_bodies;
};
