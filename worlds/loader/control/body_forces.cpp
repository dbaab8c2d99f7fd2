#include "loader/control/body_forces.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

const Parameters &checked(const Parameters &parameters) {
    parameters.expectOnly({"name", "filename"}, {"link", "linear_drag", "quadratic_drag", "righting_moment"},
                          {"phase", "repeat"});
    return parameters;
}

dBodyID findLink(const Parameters &link, const FindBody &findBody) {
    const std::vector<std::string> words = link.words();
    if (words.size() != 1) link.fail("names no link");
    return findBody(words[0], link);
}

}  // namespace

BodyForces::BodyForces(const Parameters &parameters, const FindBody &findBody, double stepSize)
    : m_body(findLink(checked(parameters).requiredValue("link"), findBody)),
      m_stepSize(stepSize),
      m_linearDrag(readDrag(parameters, "linear_drag")),
      m_quadraticDrag(readDrag(parameters, "quadratic_drag")),
      m_rightingMoment(parameters.childNumber("righting_moment", 0)),
      m_stopping(largestDrag()),
      m_timeline(parameters, {"phase"}, stepSize, [this](const Parameters &phase) {
          phase.expectOnly({"duration"}, {});
          m_thrusts.push_back(toWrench(phase.numbers(Wrench().size())));
      }) {}

BodyForces::Wrench BodyForces::toWrench(const std::vector<double> &numbers) {
    Wrench wrench{};
    std::copy_n(numbers.begin(), wrench.size(), wrench.begin());
    return wrench;
}

BodyForces::Wrench BodyForces::readDrag(const Parameters &parameters, const std::string &name) {
    if (!parameters.child(name)) return Wrench{};
    return toWrench(parameters.requiredValue(name).notNegativeNumbers(Wrench().size()));
}

// The inertia about one axis alone is a bound: products of inertia only make a body harder to turn.
BodyForces::Wrench BodyForces::largestDrag() const {
    dMass mass;
    dBodyGetMass(m_body, &mass);
    const double linear = mass.mass / m_stepSize;
    return {linear, linear, linear, mass.I[0] / m_stepSize, mass.I[5] / m_stepSize, mass.I[10] / m_stepSize};
}

void BodyForces::update(long frame) {
    const Wrench &thrust = m_thrusts[m_timeline.at(frame).phase];
    const bool pushes = std::any_of(thrust.begin(), thrust.end(), [](double part) { return part != 0; });
    if (pushes) dBodyEnable(m_body);
    if (!dBodyIsEnabled(m_body)) return;  // ODE would keep the forces for the day it wakes

    dVector3 linear, angular, up;
    dBodyVectorFromWorld(m_body, dBodyGetLinearVel(m_body)[0], dBodyGetLinearVel(m_body)[1],
                         dBodyGetLinearVel(m_body)[2], linear);
    dBodyVectorFromWorld(m_body, dBodyGetAngularVel(m_body)[0], dBodyGetAngularVel(m_body)[1],
                         dBodyGetAngularVel(m_body)[2], angular);
    dBodyVectorFromWorld(m_body, 0, 0, 1, up);

    const Wrench speed = {linear[0], linear[1], linear[2], angular[0], angular[1], angular[2]};
    Wrench total = thrust;
    for (std::size_t i = 0; i < total.size(); ++i)
        total[i] -= std::min(m_linearDrag[i] + m_quadraticDrag[i] * std::fabs(speed[i]), m_stopping[i]) * speed[i];
    total[3] -= m_rightingMoment * up[1];  // z × up
    total[4] += m_rightingMoment * up[0];
    dBodyAddRelForce(m_body, toReal(total[0]), toReal(total[1]), toReal(total[2]));
    dBodyAddRelTorque(m_body, toReal(total[3]), toReal(total[4]), toReal(total[5]));
}

}  // namespace worlds
