// A world whose bodies and joints are drawn from a seed: joints of many kinds with motors, stops and feedback, contacts with bounded
// friction, kinematic and gyroscopic bodies. Two of one seed are the same in every bit.
#pragma once

#include <ode/ode.h>

#include <list>
#include <random>
#include <vector>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

class RandomIsland {
public:
    RandomIsland(unsigned seed, unsigned bodyCount);
    ~RandomIsland() { dWorldDestroy(world); }
    RandomIsland(const RandomIsland &) = delete;
    RandomIsland &operator=(const RandomIsland &) = delete;

    // Positions, orientations, velocities, accumulators and feedback.
    std::vector<dReal> state() const;

    const dWorldID world = dWorldCreate();
    std::vector<dxBody *> bodies;
    std::vector<dxJoint *> joints;

private:
    dReal number(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(m_random); }
    bool chance(unsigned percent) { return m_random() % 100 < percent; }
    void addBody();
    void addJoint(dBodyID body1, dBodyID body2);
    dJointID makeContact(dBodyID body1, dBodyID body2);
    dJointID makeJoint();

    std::mt19937 m_random;
    std::list<dJointFeedback> m_feedbacks;
};
