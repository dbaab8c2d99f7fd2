// The controllers that a <plugin> of a model can name.
#pragma once

#include "loader/control/controller.h"
#include "loader/control/joint_motor.h"
#include "loader/description/world_description.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace worlds {

// The motor of a joint of the model, "joint" or "joint/axis2"; fails at `namedBy` when there is none.
using FindMotor = std::function<JointMotor(const std::string &joint, const Element &namedBy)>;

// The body of a link of the model; fails at `namedBy` when there is none.
using FindBody = std::function<dBodyID(const std::string &link, const Element &namedBy)>;

// Numbers of controllers' parameters are no larger: ODE stays finite with such speeds and angles.
constexpr double kMaxControllerNumber = 1e10;

// Values of a plugin's filename.
std::vector<std::string> controllerTypes();
bool isControllerType(const std::string &type);

// Throws LoadError for parameters that make no sense.
std::unique_ptr<Controller> createController(const ControllerDescription &description,
                                             const FindMotor &findMotor, const FindBody &findBody,
                                             double stepSize);

// For controllers: the motors named by the words of <joints>.
std::vector<JointMotor> findMotors(const Element &joints, const FindMotor &findMotor);

// For controllers: one speed for each of `count` motors.
std::vector<double> readSpeeds(const Element &element, std::size_t count);

// For controllers: the <gain> of those that follow positions, in 1/s: not negative, and at most what reaches the target within a step.
double readGain(const Element &parameters, double stepSize);

// For controllers: a duration in whole steps, at least one.
long toSteps(double duration, double stepSize, const Element &writtenIn);

}  // namespace worlds
