// Drag on a body, taken from its speeds before the step. Along one axis after the other, each from the speeds that those before
// leave, and cut to what stops the body's motion along that axis within the step: so drag never adds energy, however large
// it is, off the centre of mass too, and with products of inertia.
#pragma once

#include "loader/description/geometry.h"

#include <ode/ode.h>

namespace worlds {

class DampedBody {
public:

    // Keeps the body's mass. `stepSize` in s.
    DampedBody(dBodyID body, double stepSize);

    dBodyID body() const { return m_body; }

    // Reads the body's speeds; no forces so far.
    void begin();
    // Drag along an axis of the body (0 to 2) at a point of it, in m from the centre of mass: N·s/m and N·s²/m².
    void dragAlong(int axis, const Vector3 &point, double linear, double quadratic);
    // Drag about an axis of the body: N·m·s and N·m·s².
    void dragAbout(int axis, double linear, double quadratic);
    // Adds the forces since begin() to the body.
    void apply() const;

private:
    void drag(const Vector3 &along, const Vector3 &about, double linear, double quadratic);

    dBodyID m_body;
    double m_stepSize, m_inverseMass;
    Matrix3 m_inverseInertia;
    Vector3 m_velocity, m_spin, m_force, m_torque;  // along the body's axes
};

}  // namespace worlds
