// Drag on a body, taken from its speeds before the step. Along one axis after the other, each from the speeds that those before
// leave, and cut to what stops the body's motion along that axis within the step: so drag never adds energy, however large
// it is, off the centre of mass too, and with products of inertia.
#pragma once

#include <ode/ode.h>
#include <ignition/math/Matrix3.hh>
#include <ignition/math/Vector3.hh>

namespace worlds {

class DampedBody {
public:
    using Vector3d = ignition::math::Vector3d;

    // Keeps the body's mass. `stepSize` in s.
    DampedBody(dBodyID body, double stepSize);

    dBodyID body() const { return m_body; }

    // Reads the body's speeds; no forces so far.
    void begin();
    // Drag along an axis of the body (0 to 2) at a point of it, in m from the centre of mass: N·s/m and N·s²/m².
    void dragAlong(int axis, const Vector3d &point, double linear, double quadratic);
    // Drag about an axis of the body: N·m·s and N·m·s².
    void dragAbout(int axis, double linear, double quadratic);
    // Adds the forces since begin() to the body.
    void apply() const;

private:
    void drag(const Vector3d &along, const Vector3d &about, double linear, double quadratic);

    dBodyID m_body;
    double m_stepSize, m_inverseMass;
    ignition::math::Matrix3d m_inverseInertia;
    Vector3d m_velocity, m_spin, m_force, m_torque;  // along the body's axes
};

}  // namespace worlds
