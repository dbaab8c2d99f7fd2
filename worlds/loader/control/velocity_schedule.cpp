#include "loader/control/velocity_schedule.h"

#include <cmath>

namespace worlds {

namespace {

constexpr std::size_t maxPhases = 1000000;  // a schedule is kept written out

}  // namespace

VelocitySchedule::VelocitySchedule(const Parameters &parameters, const FindMotor &findMotor,
                                   double stepSize) {
    parameters.expectOnly({"name", "filename"}, {"joints"}, {"phase", "repeat"});
    m_motors = findMotors(parameters.requiredValue("joints"), findMotor);
    append(parameters, stepSize, true);
    if (m_phases.empty()) parameters.fail("has no phases");
}

void VelocitySchedule::append(const Parameters &list, double stepSize, bool outermost) {
    for (const Parameters &element : list.children) {
        if (element.name == "joints") continue;
        if (m_loops) element.fail("comes after a repeat without end");
        if (element.name == "phase")
            appendPhase(element, stepSize);
        else
            appendRepeat(element, stepSize, outermost);
    }
}

void VelocitySchedule::appendPhase(const Parameters &phase, double stepSize) {
    phase.expectOnly({"duration"}, {});
    if (m_phases.size() == maxPhases) phase.fail("makes more than 1000000 phases");
    const long start = m_phases.empty() ? 0 : m_phases.back().end;
    const long steps = toSteps(phase.attributeNumber("duration"), stepSize, phase);
    m_phases.push_back({start + steps, readSpeeds(phase, m_motors.size())});
}

void VelocitySchedule::appendRepeat(const Parameters &repeat, double stepSize, bool outermost) {
    repeat.expectOnly({"count"}, {}, {"phase", "repeat"});
    if (repeat.children.empty()) repeat.fail("repeats nothing");
    if (repeat.attributes.count("count")) {
        const double count = repeat.attributeNumber("count");
        if (!(count >= 1 && count <= maxPhases) || count != std::floor(count))
            repeat.fail("count is not a whole number between 1 and 1000000");
        for (long i = 0; i < static_cast<long>(count); ++i) append(repeat, stepSize, false);
        return;
    }
    if (!outermost) repeat.fail("without count stands inside another one");
    m_loopStart = m_phases.size();
    append(repeat, stepSize, false);
    m_loops = true;
}

void VelocitySchedule::update(long frame) {
    while (frame - m_loopedFrames >= m_phases[m_current].end) {
        if (m_current + 1 < m_phases.size()) {
            ++m_current;
        } else if (m_loops) {
            const long loopBegin = m_loopStart == 0 ? 0 : m_phases[m_loopStart - 1].end;
            m_loopedFrames += m_phases.back().end - loopBegin;
            m_current = m_loopStart;
        } else {
            break;
        }
    }
    const std::vector<double> &speeds = m_phases[m_current].speeds;
    for (std::size_t i = 0; i < m_motors.size(); ++i) m_motors[i].setSpeed(speeds[i]);
}

}  // namespace worlds
