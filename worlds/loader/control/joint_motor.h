// The motor of one joint axis, as a controller sees it.
#pragma once

#include "loader/description/world_description.h"
#include "loader/scene/joint_axis_handle.h"

namespace worlds {

class JointMotor {
public:
    // The axis's <effort> and <velocity> bound force and speed. Once a motor is used, its force limit
    // replaces the axis's <friction>.
    JointMotor(JointAxisHandle axis, const JointAxis &description);

    // rad/s or m/s, clamped to the motor's largest speed. A motor that should move enables its bodies.
    void setSpeed(double speed);

    // rad or m, 0 at the start. ODE's angles end at half a turn; this one counts on, if it is asked for at least
    // once in half a turn.
    double position();

private:
    JointAxisHandle m_axis;
    double m_maxForce, m_maxSpeed;
    double m_position = 0;  // of the last call
};

}  // namespace worlds
