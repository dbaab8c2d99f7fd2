#include "loader/control/timeline.h"

#include <algorithm>
#include <cmath>

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

}  // namespace worlds
