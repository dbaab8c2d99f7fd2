#include "loader/scene/joint_axis_handle.h"

namespace worlds {

void JointAxisHandle::set(int parameter, dReal value) const {
    switch (dJointGetType(m_joint)) {
        case dJointTypeHinge:
            return dJointSetHingeParam(m_joint, parameter, value);
        case dJointTypeSlider:
            return dJointSetSliderParam(m_joint, parameter, value);
        case dJointTypeUniversal:  // ODE's second axis is the parent's, SDF's first
            return dJointSetUniversalParam(m_joint, m_axis == 0 ? parameter + dParamGroup2 : parameter,
                                           value);
        case dJointTypeHinge2:
            return dJointSetHinge2Param(m_joint, m_axis == 0 ? parameter : parameter + dParamGroup2, value);
        default:
            break;
    }
}

dReal JointAxisHandle::position() const {
    switch (dJointGetType(m_joint)) {
        case dJointTypeHinge:
            return dJointGetHingeAngle(m_joint);
        case dJointTypeSlider:
            return dJointGetSliderPosition(m_joint);
        case dJointTypeUniversal:
            return m_axis == 0 ? dJointGetUniversalAngle2(m_joint) : dJointGetUniversalAngle1(m_joint);
        case dJointTypeHinge2:
            // ODE counts the second angle the other way round than its rate.
            return m_axis == 0 ? dJointGetHinge2Angle1(m_joint) : -dJointGetHinge2Angle2(m_joint);
        default:
            return 0;
    }
}

dReal JointAxisHandle::rate() const {
    switch (dJointGetType(m_joint)) {
        case dJointTypeHinge:
            return dJointGetHingeAngleRate(m_joint);
        case dJointTypeSlider:
            return dJointGetSliderPositionRate(m_joint);
        case dJointTypeUniversal:
            return m_axis == 0 ? dJointGetUniversalAngle2Rate(m_joint)
                               : dJointGetUniversalAngle1Rate(m_joint);
        case dJointTypeHinge2:
            return m_axis == 0 ? dJointGetHinge2Angle1Rate(m_joint) : dJointGetHinge2Angle2Rate(m_joint);
        default:
            return 0;
    }
}

void JointAxisHandle::addForce(dReal force) const {
    const dReal first = m_axis == 0 ? force : 0, second = m_axis == 0 ? 0 : force;
    switch (dJointGetType(m_joint)) {
        case dJointTypeHinge:
            return dJointAddHingeTorque(m_joint, force);
        case dJointTypeSlider:
            return dJointAddSliderForce(m_joint, force);
        case dJointTypeUniversal:
            return dJointAddUniversalTorques(m_joint, second, first);
        case dJointTypeHinge2:
            return dJointAddHinge2Torques(m_joint, first, second);
        default:
            break;
    }
}

bool JointAxisHandle::isAwake() const {
    for (int i = 0; i < 2; ++i)
        if (const dBodyID body = dJointGetBody(m_joint, i))
            if (dBodyIsEnabled(body)) return true;
    return false;
}

void JointAxisHandle::wake() const {
    for (int i = 0; i < 2; ++i)
        if (const dBodyID body = dJointGetBody(m_joint, i)) dBodyEnable(body);
}

}  // namespace worlds
