#include "loader/control/joint_motor.h"

#include "loader/description/geometry.h"
#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

JointMotor::JointMotor(JointAxisHandle axis, const JointAxis &description)
    : m_axis(axis), m_maxForce(description.maxForce), m_maxSpeed(description.maxSpeed) {}

void JointMotor::setSpeed(double speed) {
    const double cut = std::clamp(speed, -m_maxSpeed, m_maxSpeed);
    m_axis.set(dParamVel, toReal(cut));
    m_axis.set(dParamFMax, toReal(m_maxForce));
    if (cut != 0) m_axis.wake();
}

double JointMotor::position() {
    const double measured = m_axis.position();
    m_position = m_axis.isAngular() ? measured + kTurn * std::round((m_position - measured) / kTurn) : measured;
    return m_position;
}

}  // namespace worlds
