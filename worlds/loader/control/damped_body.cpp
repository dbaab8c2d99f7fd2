#include "loader/control/damped_body.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

using Vector = DampedBody::Vector;

double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void add(Vector &sum, double factor, const Vector &vector) {
    for (int i = 0; i < 3; ++i) sum[i] += factor * vector[i];
}

Vector axisVector(int axis) {
    Vector vector{};
    vector[axis] = 1;
    return vector;
}

Vector alongBody(dBodyID body, const dReal *inWorld) {
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
        for (int j = 0; j < 3; ++j) m_inverseInertia[i][j] = inverse[4 * i + j];
}

void DampedBody::begin() {
    m_velocity = alongBody(m_body, dBodyGetLinearVel(m_body));
    m_spin = alongBody(m_body, dBodyGetAngularVel(m_body));
    m_force = m_torque = {};
}

void DampedBody::dragAlong(int axis, const Vector &point, double linear, double quadratic) {
    const Vector along = axisVector(axis);
    drag(along, cross(point, along), linear, quadratic);
}

void DampedBody::dragAbout(int axis, double linear, double quadratic) { drag({}, axisVector(axis), linear, quadratic); }

void DampedBody::drag(const Vector &along, const Vector &about, double linear, double quadratic) {
    const double speed = dot(along, m_velocity) + dot(about, m_spin);
    const Vector turned = turnedBy(about);
    const double inverseMass = m_inverseMass * dot(along, along) + dot(about, turned);  // as it is felt along this axis
    const double most = 1 / (m_stepSize * inverseMass);
    const double force = -std::min(linear + quadratic * std::fabs(speed), most) * speed;
    add(m_force, force, along);
    add(m_torque, force, about);
    add(m_velocity, m_stepSize * force * m_inverseMass, along);
    add(m_spin, m_stepSize * force, turned);
}

Vector DampedBody::turnedBy(const Vector &torque) const {
    return {dot(m_inverseInertia[0], torque), dot(m_inverseInertia[1], torque), dot(m_inverseInertia[2], torque)};
}

void DampedBody::apply() const {
    dBodyAddRelForce(m_body, toReal(m_force[0]), toReal(m_force[1]), toReal(m_force[2]));
    dBodyAddRelTorque(m_body, toReal(m_torque[0]), toReal(m_torque[1]), toReal(m_torque[2]));
}

}  // namespace worlds
