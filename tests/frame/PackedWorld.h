// Boxes packed on a plane so that all touch their neighbours and are one island, in a hash space.
#pragma once

#include <ode/ode.h>

#include <vector>

class PackedWorld {
public:
    PackedWorld(int columns, int rows, int layers, dWorldStepFunction *stepper);
    ~PackedWorld();
    PackedWorld(const PackedWorld &) = delete;
    PackedWorld &operator=(const PackedWorld &) = delete;

    dWorldID world() const { return m_world; }
    void frame();

    // Pose and velocities of all bodies.
    std::vector<dReal> state() const;

private:
    void addBox(dReal x, dReal y, dReal z);
    void makeContacts(dGeomID o1, dGeomID o2);

    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_group;
    dWorldStepFunction *m_stepper;
    std::vector<dBodyID> m_bodies;
};
