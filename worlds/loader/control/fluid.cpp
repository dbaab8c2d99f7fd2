#include "loader/control/fluid.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

std::array<double, 3> readVector(const Element &element, const std::string &name, bool mayBeNegative) {
    if (!element.child(name)) return {};
    const Element &child = element.requiredValue(name);
    const std::vector<double> numbers = mayBeNegative ? child.numbers(3) : child.notNegativeNumbers(3);
    return {numbers[0], numbers[1], numbers[2]};
}

double notNegative(const Element &element, double number) {
    if (number < 0) element.fail("is negative");
    return number;
}

}  // namespace

Fluid::Fluid(const Element &parameters, const FindBody &findBody, double stepSize) : m_stepSize(stepSize) {
    parameters.expectOnly({"name", "filename"}, {"surface", "density"}, {"immersed"});
    m_surface = parameters.requiredValue("surface").number();
    const Element &density = parameters.requiredValue("density");
    m_density = notNegative(density, density.number());
    for (const Element &element : parameters.children)
        if (element.name == "immersed") m_links.push_back(readImmersed(element, findBody));
    if (m_links.empty()) parameters.fail("immerses no link");
}

Fluid::Immersed Fluid::readImmersed(const Element &element, const FindBody &findBody) const {
    element.expectOnly({"link"}, {"size", "center", "drag", "spin_drag"});
    element.requiredValue("size");
    Immersed link{{findBody(element.attribute("link"), element), m_stepSize}, {}, {}, {}, 0};
    link.size = readVector(element, "size", false);
    link.center = readVector(element, "center", true);
    const Vector coefficients = readVector(element, "drag", false);
    for (int i = 0; i < 3; ++i)
        link.drag[i] = 0.5 * m_density * coefficients[i] * link.size[(i + 1) % 3] * link.size[(i + 2) % 3];
    link.spinDrag = notNegative(element, element.childNumber("spin_drag", 0));
    return link;
}

// Returns the share of the box below the surface.
double Fluid::share(const Immersed &link) const {
    dVector3 middle;
    dBodyGetRelPointPos(link.body.body(), toReal(link.center[0]), toReal(link.center[1]), toReal(link.center[2]),
                        middle);
    const dReal *rotation = dBodyGetRotation(link.body.body());
    double height = 0;
    for (int i = 0; i < 3; ++i) height += std::fabs(rotation[8 + i]) * link.size[i];
    if (height == 0) return middle[2] < m_surface ? 1 : 0;
    return std::clamp((m_surface - middle[2]) / height + 0.5, 0.0, 1.0);
}

void Fluid::update(long) {
    for (Immersed &link : m_links)
        if (dBodyIsEnabled(link.body.body())) push(link);  // ODE would keep the forces for the day it wakes
}

void Fluid::push(Immersed &link) const {
    const double immersed = share(link);
    if (immersed == 0) return;
    const dBodyID body = link.body.body();

    dVector3 gravity;
    dWorldGetGravity(dBodyGetWorld(body), gravity);
    const double displaced = immersed * m_density * link.size[0] * link.size[1] * link.size[2];  // kg
    dBodyAddForceAtRelPos(body, toReal(-displaced * gravity[0]), toReal(-displaced * gravity[1]), toReal(-displaced * gravity[2]),
                          toReal(link.center[0]), toReal(link.center[1]), toReal(link.center[2]));

    const Vector3 center{link.center[0], link.center[1], link.center[2]};
    link.body.begin();
    for (int axis = 0; axis < 3; ++axis) link.body.dragAlong(axis, center, 0, immersed * link.drag[axis]);
    for (int axis = 0; axis < 3; ++axis) link.body.dragAbout(axis, immersed * link.spinDrag, 0);
    link.body.apply();
}

}  // namespace worlds
