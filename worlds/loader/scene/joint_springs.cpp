#include "loader/scene/joint_springs.h"

#include "loader/scene/ode_types.h"

#include <algorithm>

namespace worlds {

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
