#include "loader/control/controller.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "loader/control/body_forces.h"
#include "loader/control/fluid.h"
#include "loader/control/fourier_gait.h"
#include "loader/control/schedule.h"
#include "loader/control/random_cycle.h"
#include "loader/description/geometry.h"
#include "loader/scene/ode_types.h"

namespace worlds {

JointMotor::JointMotor(JointAxisHandle axis, const JointAxis &description)
    : m_axis(axis), m_maxForce(description.maxForce), m_maxSpeed(description.maxSpeed) {}

void JointMotor::setSpeed(double speed) {
    const double cut = std::clamp(speed, -m_maxSpeed, m_maxSpeed);
    m_axis.set(dParamVel, toReal(cut));
    m_axis.set(dParamFMax, toReal(m_maxForce));
    if (cut != 0) m_axis.wake();
}

double JointMotor::position() {
    const double measured = m_axis.position();
    m_position = m_axis.isAngular() ? measured + kTurn * std::round((m_position - measured) / kTurn) : measured;
    return m_position;
}

namespace {

using Create = std::unique_ptr<Controller> (*)(const Element &, const FindMotor &, const FindBody &,
                                               double stepSize);

template <class Kind>
std::unique_ptr<Controller> create(const Element &parameters, const FindMotor &findMotor, const FindBody &,
                                   double stepSize) {
    return std::make_unique<Kind>(parameters, findMotor, stepSize);
}

std::unique_ptr<Controller> createBodyForces(const Element &parameters, const FindMotor &,
                                             const FindBody &findBody, double stepSize) {
    return std::make_unique<BodyForces>(parameters, findBody, stepSize);
}

std::unique_ptr<Controller> createFluid(const Element &parameters, const FindMotor &, const FindBody &findBody,
                                        double stepSize) {
    return std::make_unique<Fluid>(parameters, findBody, stepSize);
}

const std::map<std::string, Create> &registry() {
    static const std::map<std::string, Create> controllers = {
        {"odemt-body-forces", createBodyForces},
        {"odemt-fluid", createFluid},
        {"odemt-fourier-gait", create<FourierGait>},
        {"odemt-position-schedule", create<PositionSchedule>},
        {"odemt-random-cycle", create<RandomCycle>},
        {"odemt-velocity-schedule", create<VelocitySchedule>},
    };
    return controllers;
}

}  // namespace

std::vector<std::string> controllerTypes() {
    std::vector<std::string> types;
    for (const auto &entry : registry()) types.push_back(entry.first);
    return types;
}

bool isControllerType(const std::string &type) { return registry().count(type) > 0; }

std::unique_ptr<Controller> createController(const ControllerDescription &description,
                                             const FindMotor &findMotor, const FindBody &findBody,
                                             double stepSize) {
    return registry().at(description.type)(*description.parameters, findMotor, findBody, stepSize);
}

std::vector<JointMotor> findMotors(const Element &joints, const FindMotor &findMotor) {
    std::vector<JointMotor> motors;
    for (const std::string &name : joints.words()) motors.push_back(findMotor(name, joints));
    if (motors.empty()) joints.fail("names no joints");
    return motors;
}

std::vector<double> readSpeeds(const Element &element, std::size_t count) {
    const std::vector<double> speeds = element.numbers();
    if (speeds.size() != count)
        element.fail("has " + std::to_string(speeds.size()) + " speeds for " + std::to_string(count) +
                     " joints");
    return speeds;
}

double readGain(const Element &parameters, double stepSize) {
    const Element &element = parameters.requiredValue("gain");
    const double gain = element.number();
    if (gain < 0) element.fail("is negative");
    if (gain * stepSize > 1) element.fail("goes beyond the target within a step: it is more than 1 / max_step_size");
    return gain;
}

long toSteps(double duration, double stepSize, const Element &writtenIn) {
    const double steps = std::round(duration / stepSize);
    if (steps < 1) writtenIn.fail("lasts less than half a step");
    if (steps > 1e9) writtenIn.fail("lasts more than 1e9 steps");
    return static_cast<long>(steps);
}

}  // namespace worlds
