// Robots of hinges with motors that stand on contacts: each is an island with many rows without limits and some with.
#pragma once

#include <ode/ode.h>

#include <random>
#include <vector>

class RobotWorld {
public:
    struct Shape {
        unsigned robots = 1, links = 17;
        unsigned contacts = 8;  // of each robot
        dReal cfm = dReal(1e-10);
    };

    RobotWorld(const Shape &shape, unsigned seed) : m_random(seed), m_world(dWorldCreate()), m_contacts(dJointGroupCreate(0)) {
        dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
        dWorldSetCFM(m_world, shape.cfm);
        for (unsigned i = 0; i < shape.robots; ++i) addRobot(shape);
    }
    ~RobotWorld() {
        dJointGroupDestroy(m_contacts);
        dWorldDestroy(m_world);
    }
    RobotWorld(const RobotWorld &) = delete;
    RobotWorld &operator=(const RobotWorld &) = delete;

    dWorldID world() const { return m_world; }

    std::vector<dReal> velocities() const {
        std::vector<dReal> all;
        for (const dBodyID link : m_links)
            for (unsigned axis = 0; axis < 3; ++axis) {
                all.push_back(dBodyGetLinearVel(link)[axis]);
                all.push_back(dBodyGetAngularVel(link)[axis]);
            }
        return all;
    }

private:
    dReal number() { return std::uniform_real_distribution<dReal>(-1, 1)(m_random); }

    // A tree: each link hangs on an earlier one.
    void addRobot(const Shape &shape) {
        const std::size_t first = m_links.size();
        for (unsigned i = 0; i < shape.links; ++i) {
            const dBodyID link = dBodyCreate(m_world);
            dMass mass;
            dMassSetBoxTotal(&mass, dReal(1.5) + number(), dReal(0.2), dReal(0.3), dReal(0.5));
            dBodySetMass(link, &mass);
            dBodySetPosition(link, number(), number(), dReal(0.3) * i);
            dBodySetAngularVel(link, number(), number(), number());
            if (i > 0) addHinge(link, m_links[first + (i - 1) / 2 + m_random() % (i - (i - 1) / 2)]);
            m_links.push_back(link);
        }
        for (unsigned i = 0; i < shape.contacts; ++i) addContact(m_links[first + m_random() % 2]);
    }

    void addHinge(dBodyID link, dBodyID parent) {
        const dJointID joint = dJointCreateHinge(m_world, nullptr);
        dJointAttach(joint, link, parent);
        const dReal *const position = dBodyGetPosition(link);
        dJointSetHingeAnchor(joint, position[0], position[1] + dReal(0.2), position[2]);
        dJointSetHingeAxis(joint, number(), number(), 1);
        dJointSetHingeParam(joint, dParamVel, number());
        dJointSetHingeParam(joint, dParamFMax, 5 + 4 * number());
    }

    void addContact(dBodyID link) {
        dContact contact = {};
        contact.surface.mode = dContactApprox1;
        contact.surface.mu = dReal(0.7);
        const dReal *const position = dBodyGetPosition(link);
        for (unsigned axis = 0; axis < 3; ++axis) contact.geom.pos[axis] = position[axis] + dReal(0.2) * number();
        contact.geom.normal[2] = 1;
        contact.geom.depth = dReal(0.001);
        dJointAttach(dJointCreateContact(m_world, m_contacts, &contact), link, nullptr);
    }

    std::mt19937 m_random;
    const dWorldID m_world;
    const dJointGroupID m_contacts;
    std::vector<dBodyID> m_links;
};
