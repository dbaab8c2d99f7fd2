#include "loader/control/velocity_schedule.h"

namespace worlds {

namespace {

const Element &checkedVelocities(const Element &parameters) {
    parameters.expectOnly({"name", "filename"}, {"joints"}, {"phase", "repeat"});
    return parameters;
}

}  // namespace

VelocitySchedule::VelocitySchedule(const Element &parameters, const FindMotor &findMotor, double stepSize)
    : m_motors(findMotors(checkedVelocities(parameters).requiredValue("joints"), findMotor)),
      m_timeline(parameters, {"phase"}, stepSize, [this](const Element &phase) {
          phase.expectOnly({"duration"}, {});
          m_speeds.push_back(readSpeeds(phase, m_motors.size()));
      }) {}

void VelocitySchedule::update(long frame) {
    const std::vector<double> &speeds = m_speeds[m_timeline.at(frame).phase];
    for (std::size_t i = 0; i < m_motors.size(); ++i) m_motors[i].setSpeed(speeds[i]);
}

}  // namespace worlds
