#include "loader/control/schedule.h"

#include <algorithm>
#include <cmath>

#include "loader/description/geometry.h"

namespace worlds {

namespace {

// A schedule is kept written out.
constexpr std::size_t kMaxPhases = 1000000, kMaxNumbers = 4000000;

// Numbers of a phase, in its text or in its elements' texts.
std::size_t countNumbers(const Element &phase) {
    std::size_t count = phase.words().size();
    for (const Element &element : phase.children) count += element.words().size();
    return count;
}

}  // namespace

Timeline::Timeline(const Element &schedule, std::vector<std::string> phaseNames, double stepSize,
                   const AddPhase &addPhase)
    : m_phaseNames(std::move(phaseNames)), m_stepSize(stepSize) {
    append(schedule, true, addPhase);
    if (m_ends.empty()) schedule.fail("has no phases");
}

void Timeline::append(const Element &list, bool outermost, const AddPhase &addPhase) {
    for (const Element &element : list.children) {
        const bool isPhase =
            std::find(m_phaseNames.begin(), m_phaseNames.end(), element.name) != m_phaseNames.end();
        if (!isPhase && element.name != "repeat") continue;
        if (m_loops) element.fail("comes after a repeat without end");
        if (!isPhase) {
            appendRepeat(element, outermost, addPhase);
            continue;
        }
        if (m_ends.size() == kMaxPhases) element.fail("makes more than " + std::to_string(kMaxPhases) + " phases");
        m_numbers += countNumbers(element);
        if (m_numbers > kMaxNumbers) element.fail("makes more than " + std::to_string(kMaxNumbers) + " numbers");
        const long steps = toSteps(element.attributeNumber("duration"), m_stepSize, element);
        m_ends.push_back(startOf(m_ends.size()) + steps);
        addPhase(element);
    }
}

void Timeline::appendRepeat(const Element &repeat, bool outermost, const AddPhase &addPhase) {
    std::vector<std::string> known = m_phaseNames;
    known.emplace_back("repeat");
    repeat.expectOnly({"count"}, {}, known);
    if (repeat.children.empty()) repeat.fail("repeats nothing");
    if (repeat.findAttribute("count")) {
        const double count = repeat.attributeNumber("count");
        if (!(count >= 1 && count <= kMaxPhases) || count != std::floor(count))
            repeat.fail("count is not a whole number between 1 and " + std::to_string(kMaxPhases));
        for (long i = 0; i < static_cast<long>(count); ++i) append(repeat, false, addPhase);
        return;
    }
    if (!outermost) repeat.fail("without count stands inside another one");
    m_loopStart = m_ends.size();
    append(repeat, false, addPhase);
    m_loops = true;
}

Timeline::Moment Timeline::at(long frame) {
    while (frame - m_loopedFrames >= m_ends[m_current]) {
        if (m_current + 1 < m_ends.size()) {
            ++m_current;
        } else if (m_loops) {
            m_loopedFrames += m_ends.back() - startOf(m_loopStart);
            m_current = m_loopStart;
        } else {
            break;
        }
    }
    const long start = startOf(m_current);
    return {m_current, frame - m_loopedFrames - start, m_ends[m_current] - start};
}

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
