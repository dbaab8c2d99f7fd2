// The phases of a schedule in time: each lasts so many frames, some are repeated, the last ones perhaps for
// ever.
//
//   <PHASE duration="0.5"/>                 s, rounded to whole steps
//   <repeat count="3"> … </repeat>          phases and repeats, so many times
//   <repeat> … </repeat>                    without count: endless, so it comes last
//
// After the last phase time goes on in it. Names of phases are the controller's. Repeats with a count make at most
// a million phases with four million numbers.
#pragma once

#include "loader/control/controller_registry.h"

namespace worlds {

class Timeline {
public:
    // Is told of each phase in the order of time, as often as it is repeated by a count.
    using AddPhase = std::function<void(const Element &phase)>;

    // Reads the children of `schedule` that have one of the names, and the repeats.
    Timeline(const Element &schedule, std::vector<std::string> phaseNames, double stepSize,
             const AddPhase &addPhase);

    struct Moment {
        std::size_t phase;  // its number, counted as AddPhase is told of them
        long frame;         // 0 in the phase's first frame
        long frames;        // the phase's length
    };

    // Requires a frame that is no earlier than that of the call before.
    Moment at(long frame);

private:
    void append(const Element &list, bool outermost, const AddPhase &addPhase);
    void appendRepeat(const Element &repeat, bool outermost, const AddPhase &addPhase);
    long startOf(std::size_t phase) const { return phase == 0 ? 0 : m_ends[phase - 1]; }

    std::vector<std::string> m_phaseNames;
    double m_stepSize;
    std::size_t m_numbers = 0;    // of all phases
    std::vector<long> m_ends;     // first frame after each phase
    std::size_t m_loopStart = 0;  // the phases from here on are repeated endlessly,
    bool m_loops = false;         // if this is set
    std::size_t m_current = 0;
    long m_loopedFrames = 0;  // frames of the rounds that are over
};

}  // namespace worlds
