#include "loader/scene/joint_axis.h"

#include <algorithm>

#include "loader/scene/ode_types.h"

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

namespace {

// How much a body's speed along the axis changes per impulse: 1/m, or axis·I⁻¹·axis. The joint's own
// reaction only makes this smaller.
double compliance(dBodyID body, const JointAxis &axis, bool linear) {
    if (!body || dBodyIsKinematic(body)) return 0;
    dMass mass;
    dBodyGetMass(body, &mass);
    if (linear) return 1 / mass.mass;
    dMatrix3 inverse;
    dInvertPDMatrix(mass.I, inverse, 3);
    const Vector3 inBody = toQuaternion(dBodyGetQuaternion(body)).inverse() * axis.direction;
    const auto row = [&](int i) { return inverse[4 * i] * inBody.x + inverse[4 * i + 1] * inBody.y + inverse[4 * i + 2] * inBody.z; };
    return inBody.dot({row(0), row(1), row(2)});
}

}  // namespace

void JointSprings::add(dJointID joint, const Joint &description) {
    const bool linear = description.type == JointType::Prismatic;
    for (std::size_t i = 0; i < description.axes.size(); ++i) {
        const JointAxis &axis = description.axes[i];
        if (axis.damping == 0 && axis.springStiffness == 0) continue;
        // More than this would reverse the motion within one step, and be unstable.
        const double total = compliance(dJointGetBody(joint, 0), axis, linear) +
                             compliance(dJointGetBody(joint, 1), axis, linear);
        const double damping = std::min(axis.damping, 1 / (m_stepSize * total));
        m_springs.push_back({JointAxisHandle(joint, static_cast<int>(i)), toReal(damping),
                             toReal(axis.springStiffness), toReal(axis.springReference)});
    }
}

void JointSprings::apply() const {
    for (const Spring &spring : m_springs) {
        if (!spring.axis.isAwake()) continue;  // ODE would keep the forces for the day they wake
        spring.axis.addForce(-spring.damping * spring.axis.rate() -
                             spring.stiffness * (spring.axis.position() - spring.reference));
    }
}

}  // namespace worlds
