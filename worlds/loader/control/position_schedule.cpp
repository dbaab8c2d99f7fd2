#include "loader/control/position_schedule.h"

#include "loader/description/geometry.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

const Element &checkedPositions(const Element &parameters) {
    parameters.expectOnly({"name", "filename"}, {"gain", "joints"}, {"hold", "glide", "swing", "repeat"});
    return parameters;
}

std::vector<double> readOfEachJoint(const Element &element, std::size_t joints) {
    std::vector<double> numbers = element.numbers();
    if (numbers.size() != joints)
        element.fail("has " + std::to_string(numbers.size()) + " numbers for " + std::to_string(joints) +
                     " joints");
    return numbers;
}

std::vector<double> readChild(const Element &element, const std::string &name, std::size_t joints) {
    if (!element.child(name)) return std::vector<double>(joints, 0);
    return readOfEachJoint(element.requiredValue(name), joints);
}

}  // namespace

PositionSchedule::PositionSchedule(const Element &parameters, const FindMotor &findMotor, double stepSize)
    : m_stepSize(stepSize),
      m_gain(readGain(checkedPositions(parameters), stepSize)),
      m_motors(findMotors(parameters.requiredValue("joints"), findMotor)),
      m_timeline(parameters, {"hold", "glide", "swing"}, stepSize,
                 [this](const Element &element) { m_phases.push_back(readPhase(element)); }),
      m_targets(m_motors.size(), 0),
      m_phaseStarts(m_motors.size(), 0) {}

PositionSchedule::Phase PositionSchedule::readPhase(const Element &element) const {
    Phase phase;
    if (element.name == "swing") {
        phase.kind = Phase::Kind::Swing;
        readSwing(element, phase);
        return phase;
    }
    phase.kind = element.name == "hold" ? Phase::Kind::Hold : Phase::Kind::Glide;
    element.expectOnly({"duration"}, {});
    phase.center = readOfEachJoint(element, m_motors.size());
    return phase;
}

void PositionSchedule::readSwing(const Element &element, Phase &phase) const {
    element.expectOnly({"duration", "frequency"}, {"center", "amplitude", "phase", "growth"});
    phase.frequency = element.attributeNumber("frequency");
    phase.center = readChild(element, "center", m_motors.size());
    phase.amplitude = readOfEachJoint(element.requiredValue("amplitude"), m_motors.size());
    phase.turns = readChild(element, "phase", m_motors.size());
    if (!element.child("growth")) return;
    const Element &growth = element.requiredValue("growth");
    const std::vector<double> shares = growth.numbers();
    if (shares.size() != 2) growth.fail("needs two numbers");
    phase.startGrowth = shares[0];
    phase.endGrowth = shares[1];
}

double PositionSchedule::target(const Phase &phase, std::size_t joint, const Timeline::Moment &moment) const {
    const double share = static_cast<double>(moment.frame + 1) / static_cast<double>(moment.frames);
    switch (phase.kind) {
        case Phase::Kind::Hold:
            return phase.center[joint];
        case Phase::Kind::Glide:
            if (moment.frame >= moment.frames)
                return phase.center[joint];  // time has gone on in the last phase
            return m_phaseStarts[joint] + share * (phase.center[joint] - m_phaseStarts[joint]);
        case Phase::Kind::Swing:
            break;
    }
    const double time = static_cast<double>(moment.frame) * m_stepSize;
    const double growth = phase.startGrowth + std::min(share, 1.0) * (phase.endGrowth - phase.startGrowth);
    return phase.center[joint] +
           growth * phase.amplitude[joint] * std::sin(kTurn * (phase.frequency * time + phase.turns[joint]));
}

void PositionSchedule::update(long frame) {
    const Timeline::Moment moment = m_timeline.at(frame);
    if (moment.frame == 0) m_phaseStarts = m_targets;
    for (std::size_t i = 0; i < m_motors.size(); ++i) {
        m_targets[i] = target(m_phases[moment.phase], i, moment);
        m_motors[i].setSpeed(m_gain * (m_targets[i] - m_motors[i].position()));
    }
}

}  // namespace worlds
