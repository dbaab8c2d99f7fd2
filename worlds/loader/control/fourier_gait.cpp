#include "loader/control/fourier_gait.h"

#include "loader/description/geometry.h"
#include "support/text.h"

#include <cmath>

namespace worlds {

namespace {

std::vector<double> childNumbers(const Element &element, const std::string &name) {
    const Element *child = element.child(name);
    if (!child) return {};
    child->expectOnly({}, {});
    if (child->words().empty()) child->fail("is empty");
    return child->numbers();
}

}  // namespace

FourierGait::FourierGait(const Element &parameters, const FindMotor &findMotor, double stepSize)
    : m_stepSize(stepSize) {
    parameters.expectOnly({"name", "filename"}, {"gain", "start", "frequency"},
                          {"hold", "wave", "swing"});
    m_gain = readGain(parameters, stepSize);
    m_start = parameters.childNumber("start", 0);
    m_frequency = parameters.childNumber("frequency", 0);
    for (const Element &element : parameters.children)
        if (element.name == "wave" && !m_waves.emplace(element.attribute("name"), readWave(element)).second)
            element.fail("a second wave is called " + support::quote(element.attribute("name")));
    for (const Element &element : parameters.children) {
        if (element.name == "hold") {
            element.expectOnly({"joint"}, {});
            m_holds.push_back({findMotor(element.attribute("joint"), element), element.number()});
        } else if (element.name == "swing") {
            readSwing(element, findMotor);
        }
    }
    if (m_holds.empty() && m_swings.empty()) parameters.fail("drives no joints");
}

FourierGait::Wave FourierGait::readWave(const Element &element) {
    element.expectOnly({"name"}, {"constant", "cos", "sin"});
    return {element.childNumber("constant", 0), childNumbers(element, "cos"), childNumbers(element, "sin")};
}

void FourierGait::readSwing(const Element &element, const FindMotor &findMotor) {
    element.expectOnly({"joint", "wave", "phase"}, {});
    const auto wave = m_waves.find(element.attribute("wave"));
    if (wave == m_waves.end()) element.fail("there is no wave " + support::quote(element.attribute("wave")));
    m_swings.push_back(
        {findMotor(element.attribute("joint"), element), &wave->second, element.attributeNumber("phase", 0)});
}

double FourierGait::Wave::at(double phase) const {
    double angle = constant;
    for (std::size_t i = 0; i < cosines.size(); ++i)
        angle += cosines[i] * std::cos(static_cast<double>(i + 1) * phase);
    for (std::size_t i = 0; i < sines.size(); ++i)
        angle += sines[i] * std::sin(static_cast<double>(i + 1) * phase);
    return angle;
}

void FourierGait::approach(JointMotor &motor, double angle) const {
    motor.setSpeed(m_gain * (angle - motor.position()));
}

void FourierGait::update(long frame) {
    for (Hold &hold : m_holds) approach(hold.motor, hold.angle);
    const double time = static_cast<double>(frame) * m_stepSize - m_start;
    for (Swing &swing : m_swings)
        approach(swing.motor, time < 0 ? 0 : swing.wave->at(kTurn * (m_frequency * time + swing.phase)));
}

}  // namespace worlds
