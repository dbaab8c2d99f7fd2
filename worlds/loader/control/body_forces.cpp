#include "loader/control/body_forces.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

const Element &checkedForces(const Element &parameters) {
    parameters.expectOnly({"name", "filename"}, {"link", "linear_drag", "quadratic_drag", "righting_moment"},
                          {"phase", "repeat"});
    return parameters;
}

dBodyID findLink(const Element &link, const FindBody &findBody) {
    const std::vector<std::string> words = link.words();
    if (words.size() != 1) link.fail("names no link");
    return findBody(words[0], link);
}

}  // namespace

BodyForces::BodyForces(const Element &parameters, const FindBody &findBody, double stepSize)
    : m_body(findLink(checkedForces(parameters).requiredValue("link"), findBody), stepSize),
      m_linearDrag(readDrag(parameters, "linear_drag")),
      m_quadraticDrag(readDrag(parameters, "quadratic_drag")),
      m_rightingMoment(parameters.childNumber("righting_moment", 0)),
      m_timeline(parameters, {"phase"}, stepSize, [this](const Element &phase) {
          phase.expectOnly({"duration"}, {});
          m_thrusts.push_back(toWrench(phase.numbers(Wrench().size())));
      }) {}

BodyForces::Wrench BodyForces::toWrench(const std::vector<double> &numbers) {
    Wrench wrench{};
    std::copy_n(numbers.begin(), wrench.size(), wrench.begin());
    return wrench;
}

BodyForces::Wrench BodyForces::readDrag(const Element &parameters, const std::string &name) {
    if (!parameters.child(name)) return Wrench{};
    return toWrench(parameters.requiredValue(name).notNegativeNumbers(Wrench().size()));
}

void BodyForces::update(long frame) {
    const dBodyID body = m_body.body();
    const Wrench &thrust = m_thrusts[m_timeline.at(frame).phase];
    const bool pushes = std::any_of(thrust.begin(), thrust.end(), [](double part) { return part != 0; });
    if (pushes) dBodyEnable(body);
    if (!dBodyIsEnabled(body)) return;  // ODE would keep the forces for the day it wakes

    dVector3 up;
    dBodyVectorFromWorld(body, 0, 0, 1, up);
    dBodyAddRelForce(body, toReal(thrust[0]), toReal(thrust[1]), toReal(thrust[2]));
    dBodyAddRelTorque(body, toReal(thrust[3] - m_rightingMoment * up[1]),  // z × up
                      toReal(thrust[4] + m_rightingMoment * up[0]), toReal(thrust[5]));

    m_body.begin();
    for (int axis = 0; axis < 3; ++axis) m_body.dragAlong(axis, {}, m_linearDrag[axis], m_quadraticDrag[axis]);
    for (int axis = 0; axis < 3; ++axis) m_body.dragAbout(axis, m_linearDrag[3 + axis], m_quadraticDrag[3 + axis]);
    m_body.apply();
}

}  // namespace worlds
