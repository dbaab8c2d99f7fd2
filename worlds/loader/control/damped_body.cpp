#include "loader/control/damped_body.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

Vector3 axisVector(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

Vector3 alongBody(dBodyID body, const dReal *inWorld) {
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
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m_inverseInertia(i, j) = inverse[4 * i + j];
}

void DampedBody::begin() {
    m_velocity = alongBody(m_body, dBodyGetLinearVel(m_body));
    m_spin = alongBody(m_body, dBodyGetAngularVel(m_body));
    m_force = m_torque = Vector3();
}

void DampedBody::dragAlong(int axis, const Vector3 &point, double linear, double quadratic) {
    const Vector3 along = axisVector(axis);
    drag(along, point.cross(along), linear, quadratic);
}

void DampedBody::dragAbout(int axis, double linear, double quadratic) { drag(Vector3(), axisVector(axis), linear, quadratic); }

void DampedBody::drag(const Vector3 &along, const Vector3 &about, double linear, double quadratic) {
    if (linear == 0 && quadratic == 0) return;
    const double speed = along.dot(m_velocity) + about.dot(m_spin);
    const Vector3 turned = m_inverseInertia * about;
    const double inverseMass = m_inverseMass * along.squaredLength() + about.dot(turned);  // as it is felt along this axis
    const double most = 1 / (m_stepSize * inverseMass);
    const double force = -std::min(linear + quadratic * std::fabs(speed), most) * speed;
    m_force += force * along;
    m_torque += force * about;
    m_velocity += m_stepSize * force * m_inverseMass * along;
    m_spin += m_stepSize * force * turned;
}

void DampedBody::apply() const {
    dBodyAddRelForce(m_body, toReal(m_force.x), toReal(m_force.y), toReal(m_force.z));
    dBodyAddRelTorque(m_body, toReal(m_torque.x), toReal(m_torque.y), toReal(m_torque.z));
}

}  // namespace worlds
