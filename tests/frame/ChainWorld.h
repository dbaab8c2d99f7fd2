// A world of separate chains that swing from fixed points: as many islands as chains, all of them the same
// in every step. Two worlds with the same arguments are the same.
//
// Links hang on ball joints, every third one on a hinge with a motor and stops; all joints have feedback.
#pragma once

#include <ode/ode.h>

#include <deque>
#include <vector>

class ChainWorld {
public:
    ChainWorld(unsigned chains, unsigned links, dWorldStepFunction *stepper = dWorldQuickStep);
    ~ChainWorld() { dWorldDestroy(m_world); }
    ChainWorld(const ChainWorld &) = delete;
    ChainWorld &operator=(const ChainWorld &) = delete;

    void step(unsigned steps = 1);

    // Pose, velocities and accumulators of all bodies, then the feedback of all joints.
    std::vector<dReal> state() const;

    dWorldID world() const { return m_world; }
    const std::vector<dBodyID> &bodies() const { return m_bodies; }  // chain by chain
    const std::vector<dJointID> &joints() const { return m_joints; }

private:
    void addLink(unsigned chain, unsigned link);

    dWorldID m_world;
    dWorldStepFunction *m_stepper;
    std::vector<dBodyID> m_bodies;
    std::vector<dJointID> m_joints;
    std::deque<dJointFeedback> m_feedbacks;  // never moves an element
};
