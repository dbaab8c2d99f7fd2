#include "loader/control/fluid.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

std::array<double, 3> readVector(const Parameters &element, const std::string &name, bool mayBeNegative) {
    if (!element.child(name)) return {};
    const Parameters &child = element.requiredValue(name);
    const std::vector<double> numbers = mayBeNegative ? child.numbers(3) : child.notNegativeNumbers(3);
    return {numbers[0], numbers[1], numbers[2]};
}

double notNegative(const Parameters &element, double number) {
    if (number < 0) element.fail("is negative");
    return number;
}

}  // namespace

Fluid::Fluid(const Parameters &parameters, const FindBody &findBody, double stepSize) : m_stepSize(stepSize) {
    parameters.expectOnly({"name", "filename"}, {"surface", "density"}, {"immersed"});
    m_surface = parameters.requiredValue("surface").number();
    const Parameters &density = parameters.requiredValue("density");
    m_density = notNegative(density, density.number());
    for (const Parameters &element : parameters.children)
        if (element.name == "immersed") m_links.push_back(readImmersed(element, findBody));
    if (m_links.empty()) parameters.fail("immerses no link");
}

Fluid::Immersed Fluid::readImmersed(const Parameters &element, const FindBody &findBody) const {
    element.expectOnly({"link"}, {"size", "center", "drag", "spin_drag"});
    element.requiredValue("size");
    Immersed link;
    link.body = findBody(element.attribute("link"), element);
    link.size = readVector(element, "size", false);
    link.center = readVector(element, "center", true);
    const Vector coefficients = readVector(element, "drag", false);
    for (int i = 0; i < 3; ++i)
        link.drag[i] = 0.5 * m_density * coefficients[i] * link.size[(i + 1) % 3] * link.size[(i + 2) % 3];
    link.spinDrag = notNegative(element, element.childNumber("spin_drag", 0));
    dMass mass;
    dBodyGetMass(link.body, &mass);
    link.mass = mass.mass;
    // Products of inertia only make a body harder to turn about one axis.
    link.inertia = {mass.I[0], mass.I[5], mass.I[10]};
    return link;
}

// Returns the share of the box below the surface.
double Fluid::share(const Immersed &link) const {
    dVector3 middle;
    dBodyGetRelPointPos(link.body, toReal(link.center[0]), toReal(link.center[1]), toReal(link.center[2]),
                        middle);
    const dReal *rotation = dBodyGetRotation(link.body);
    double height = 0;
    for (int i = 0; i < 3; ++i) height += std::fabs(rotation[8 + i]) * link.size[i];
    if (height == 0) return middle[2] < m_surface ? 1 : 0;
    return std::clamp((m_surface - middle[2]) / height + 0.5, 0.0, 1.0);
}

void Fluid::update(long) {
    for (const Immersed &link : m_links)
        if (dBodyIsEnabled(link.body)) push(link);  // ODE would keep the forces for the day it wakes
}

void Fluid::push(const Immersed &link) const {
    const double immersed = share(link);
    if (immersed == 0) return;
    const Vector &center = link.center;
    const dReal x = toReal(center[0]), y = toReal(center[1]), z = toReal(center[2]);

    dVector3 gravity, inWorld, speed, spin;
    dWorldGetGravity(dBodyGetWorld(link.body), gravity);
    const double displaced = immersed * m_density * link.size[0] * link.size[1] * link.size[2];  // kg
    dBodyAddForceAtRelPos(link.body, toReal(-displaced * gravity[0]), toReal(-displaced * gravity[1]),
                          toReal(-displaced * gravity[2]), x, y, z);

    dBodyGetRelPointVel(link.body, x, y, z, inWorld);
    dBodyVectorFromWorld(link.body, inWorld[0], inWorld[1], inWorld[2], speed);
    const dReal *turning = dBodyGetAngularVel(link.body);
    dBodyVectorFromWorld(link.body, turning[0], turning[1], turning[2], spin);
    Vector force, torque;
    for (int i = 0; i < 3; ++i) {
        force[i] =
            -std::min(immersed * link.drag[i] * std::fabs(speed[i]), link.mass / m_stepSize) * speed[i];
        torque[i] = -std::min(immersed * link.spinDrag, link.inertia[i] / m_stepSize) * spin[i];
    }
    dBodyAddRelForceAtRelPos(link.body, toReal(force[0]), toReal(force[1]), toReal(force[2]), x, y, z);
    dBodyAddRelTorque(link.body, toReal(torque[0]), toReal(torque[1]), toReal(torque[2]));
}

}  // namespace worlds
