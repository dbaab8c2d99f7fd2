#include "loader/control/random_cycle.h"

#include <cmath>

namespace worlds {

namespace {

long whole(const Element &element, double number, double least, double most) {
    if (number != std::floor(number) || number < least || number > most)
        element.fail("needs whole numbers between " + std::to_string(static_cast<long>(least)) + " and " +
                     std::to_string(static_cast<long>(most)));
    return static_cast<long>(number);
}

}  // namespace

RandomCycle::RandomCycle(const Element &parameters, const FindMotor &findMotor, double stepSize) {
    parameters.expectOnly({"name", "filename"},
                          {"joints", "control_step", "cycle", "first_part", "second_part", "seed"});
    m_motors = findMotors(parameters.requiredValue("joints"), findMotor);

    const Element &first = parameters.required("first_part"), &second = parameters.requiredValue("second_part");
    first.expectOnly({"start", "least", "most"}, {});
    m_firstSpeeds = readSpeeds(first, m_motors.size());
    m_secondSpeeds = readSpeeds(second, m_motors.size());

    const Element &controlStep = parameters.requiredValue("control_step"),
                     &cycle = parameters.requiredValue("cycle");
    m_framesPerStep = toSteps(controlStep.number(), stepSize, controlStep);
    m_cycle = whole(cycle, cycle.number(), 1, 1e6);
    m_least = whole(first, first.attributeNumber("least"), 0, static_cast<double>(m_cycle));
    m_most = whole(first, first.attributeNumber("most"), static_cast<double>(m_least),
                   static_cast<double>(m_cycle));
    m_firstPart = whole(first, first.attributeNumber("start"), 0, static_cast<double>(m_cycle));

    const Element &seed = parameters.requiredValue("seed");
    m_random.seed(static_cast<std::minstd_rand::result_type>(whole(seed, seed.number(), 1, 2147483646)));
}

void RandomCycle::update(long frame) {
    if (frame - m_cycleStart >= m_cycle * m_framesPerStep) {
        m_cycleStart = frame;
        m_firstPart = m_least + static_cast<long>(m_random()) % (m_most - m_least + 1);
    }
    const bool inFirstPart = frame - m_cycleStart < m_firstPart * m_framesPerStep;
    const std::vector<double> &speeds = inFirstPart ? m_firstSpeeds : m_secondSpeeds;
    for (std::size_t i = 0; i < m_motors.size(); ++i) m_motors[i].setSpeed(speeds[i]);
}

}  // namespace worlds
