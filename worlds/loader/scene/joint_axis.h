// One axis of an ODE joint, whatever the type of the joint, and its damping and spring.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "loader/description/world_description.h"

namespace worlds {

// Everything counts in SDF's sense: positive is the motion of the child against the parent along the
// axis. ode_joint.cpp attaches and orients ODE's axes so that this holds.
class JointAxisHandle {
public:
    // `axis` is 0 for SDF's <axis> and 1 for <axis2>. The joint has that axis.
    JointAxisHandle(dJointID joint, int axis) : m_joint(joint), m_axis(axis) {}

    void set(int parameter, dReal value) const;  // dParamVel and the like
    dReal position() const;                      // m or rad, 0 at the start; angles between -π and π
    dReal rate() const;                          // m/s or rad/s
    void addForce(dReal force) const;            // N or N·m, for the coming step

    bool isAngular() const { return dJointGetType(m_joint) != dJointTypeSlider; }

    // A joint is awake when one of its bodies is.
    bool isAwake() const;
    void wake() const;

private:
    dJointID m_joint;
    int m_axis;
};

// Damping and springs of joint axes: forces added before every step, since ODE's joints have neither.
class JointSprings {
public:
    explicit JointSprings(double stepSize) : m_stepSize(stepSize) {}

    // Takes the axes of a joint that have damping or a spring.
    void add(dJointID joint, const Joint &description);

    // force = -damping * rate - stiffness * (position - reference)
    void apply() const;

private:
    struct Spring {
        JointAxisHandle axis;
        dReal damping, stiffness, reference;
    };

    double m_stepSize;
    std::vector<Spring> m_springs;
};

}  // namespace worlds
