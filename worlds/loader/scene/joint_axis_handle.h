// One axis of an ODE joint, whatever the type of the joint.
//
// Everything counts in SDF's sense: positive is the motion of the child against the parent along the
// axis. ode_joint.cpp attaches and orients ODE's axes so that this holds.
#pragma once

#include <ode/ode.h>

namespace worlds {

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

}  // namespace worlds
