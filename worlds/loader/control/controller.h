// Controllers, which a <plugin> of a model can name, and the motors and bodies of the model that they act on.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "loader/description/world_description.h"
#include "loader/scene/joint_axis.h"

namespace worlds {

// Acts before each step: drives motors of a model, or pushes its links. Open loop: it reads the state of its own model only.
class Controller {
public:
    virtual ~Controller() = default;

    // Before the step of frame `frame`; the first one is 0.
    virtual void update(long frame) = 0;
};

// The motor of one joint axis, as a controller sees it.
class JointMotor {
public:
    // The axis's <effort> and <velocity> bound force and speed. Once a motor is used, its force limit
    // replaces the axis's <friction>.
    JointMotor(JointAxisHandle axis, const JointAxis &description);

    // rad/s or m/s, clamped to the motor's largest speed. A motor that should move enables its bodies.
    void setSpeed(double speed);

    // rad or m, 0 at the start. ODE's angles end at half a turn; this one counts on, if it is asked for at least
    // once in half a turn.
    double position();

private:
    JointAxisHandle m_axis;
    double m_maxForce, m_maxSpeed;
    double m_position = 0;  // of the last call
};

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
