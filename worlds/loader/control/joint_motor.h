// The motor of one joint axis, as a controller sees it.
#pragma once

#include "loader/description/joint.h"
#include "loader/scene/joint_axis_handle.h"

namespace worlds {

class JointMotor {
public:
    // The axis's <effort> and <velocity> bound force and speed. Once a motor is used, its force limit
    // replaces the axis's <friction>.
    JointMotor(JointAxisHandle axis, const JointAxis &description);

    // rad/s or m/s, clamped to the motor's largest speed. A motor that should move enables its bodies.
    void setSpeed(double speed);

    double position() const { return m_axis.position(); }  // rad or m, 0 at the start

private:
    JointAxisHandle m_axis;
    double m_maxForce, m_maxSpeed;
};

}  // namespace worlds
