#include "loader/control/damped_body.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

using ignition::math::Vector3d;

Vector3d axisVector(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

Vector3d alongBody(dBodyID body, const dReal *inWorld) {
    dVector3 turned;
    dBodyVectorFromWorld(body, inWorld[0], inWorld[1], inWorld[2], turned);
    return {turned[0], turned[1], turned[2]};
}

}  // namespace

DampedBody::DampedBody(dBodyID body, double stepSize) : m_body(body), m_stepSize(stepSize) {
    dMass mass;
    dBodyGetMass(body, &mass);
    m_inverseMass = 1 / mass.mass;
    dMatrix3 inverse;
    dInvertPDMatrix(mass.I, inverse, 3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) m_inverseInertia(i, j) = inverse[4 * i + j];
}

void DampedBody::begin() {
    m_velocity = alongBody(m_body, dBodyGetLinearVel(m_body));
    m_spin = alongBody(m_body, dBodyGetAngularVel(m_body));
    m_force = m_torque = Vector3d::Zero;
}

void DampedBody::dragAlong(int axis, const Vector3d &point, double linear, double quadratic) {
    const Vector3d along = axisVector(axis);
    drag(along, point.Cross(along), linear, quadratic);
}

void DampedBody::dragAbout(int axis, double linear, double quadratic) { drag(Vector3d::Zero, axisVector(axis), linear, quadratic); }

void DampedBody::drag(const Vector3d &along, const Vector3d &about, double linear, double quadratic) {
    if (linear == 0 && quadratic == 0) return;
    const double speed = along.Dot(m_velocity) + about.Dot(m_spin);
    const Vector3d turned = m_inverseInertia * about;
    const double inverseMass = m_inverseMass * along.SquaredLength() + about.Dot(turned);  // as it is felt along this axis
    const double most = 1 / (m_stepSize * inverseMass);
    const double force = -std::min(linear + quadratic * std::fabs(speed), most) * speed;
    m_force += force * along;
    m_torque += force * about;
    m_velocity += m_stepSize * force * m_inverseMass * along;
    m_spin += m_stepSize * force * turned;
}

void DampedBody::apply() const {
    dBodyAddRelForce(m_body, toReal(m_force.X()), toReal(m_force.Y()), toReal(m_force.Z()));
    dBodyAddRelTorque(m_body, toReal(m_torque.X()), toReal(m_torque.Y()), toReal(m_torque.Z()));
}

}  // namespace worlds
