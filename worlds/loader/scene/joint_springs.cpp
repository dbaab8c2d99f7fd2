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
    const ignition::math::Matrix3d inertia(mass.I[0], mass.I[1], mass.I[2], mass.I[4], mass.I[5], mass.I[6],
                                           mass.I[8], mass.I[9], mass.I[10]);
    const dReal *q = dBodyGetQuaternion(body);
    const ignition::math::Quaterniond toWorld(q[0], q[1], q[2], q[3]);
    const ignition::math::Vector3d inBody = toWorld.RotateVectorReverse(axis.direction);
    return inBody.Dot(inertia.Inverse() * inBody);
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
