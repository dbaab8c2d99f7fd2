// Controllers that drive joints phase by phase: at given speeds, or to given positions.
#pragma once

#include "loader/control/controller.h"

namespace worlds {

// The phases of a schedule in time: each lasts a number of frames, some are repeated, the last ones perhaps for
// ever.
//
//   <PHASE duration="0.5"/>                 s, rounded to whole steps
//   <repeat count="3"> … </repeat>          phases and repeats, three times
//   <repeat> … </repeat>                    without count: endless, so it comes last
//
// After the last phase time goes on in it. Names of phases are the controller's. Repeats with a count make at most
// a million phases with four million numbers.
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

// Piecewise constant motor speeds.
//
//   <plugin name="drive" filename="odemt-velocity-schedule">
//     <joints>left right</joints>              whose speeds the phases give, in this order
//     <phase duration="0.5">0 0</phase>        s; rad/s or m/s
//     <repeat> … </repeat>                     Timeline
//   </plugin>
class VelocitySchedule : public Controller {
public:
    VelocitySchedule(const Element &parameters, const FindMotor &findMotor, double stepSize);
    void update(long frame) override;

private:
    std::vector<JointMotor> m_motors;
    std::vector<std::vector<double>> m_speeds;  // of each phase
    Timeline m_timeline;
};

// Takes joints to targets, phase by phase.
//
//   <plugin name="demo" filename="odemt-position-schedule">
//     <gain>10</gain>                                1/s; speed = gain · (target - position)
//     <joints>left right</joints>                    for which the phases give numbers, in this order
//     <hold duration="0.5">0.3 -0.3</hold>           s; rad or m: targets that stay
//     <glide duration="1">0 0</glide>                targets that move evenly from the last ones to these
//     <swing duration="7" frequency="1">             Hz; center + amplitude · sin(2π (frequency · t + phase)),
//       <center>0 0</center>                         t from the start of the phase; rad or m, 0 unless given
//       <amplitude>0.9 0.9</amplitude>
//       <phase>0 0.125</phase>                       turns, 0 unless given
//       <growth>0 1</growth>                         the amplitude's share at the start and at the end, evenly
//     </swing>                                       between; 1 1 unless given
//     <repeat> … </repeat>                           Timeline
//   </plugin>
//
// The speed is cut to the joint's <velocity>.
class PositionSchedule : public Controller {
public:
    PositionSchedule(const Element &parameters, const FindMotor &findMotor, double stepSize);
    void update(long frame) override;

private:
    using Numbers = std::vector<double>;  // one for each joint
    struct Phase {
        enum class Kind { Hold, Glide, Swing } kind;
        Numbers center;  // the targets, or what they swing about
        double frequency = 0;
        Numbers amplitude, turns;
        double startGrowth = 1, endGrowth = 1;
    };

    Phase readPhase(const Element &element) const;
    void readSwing(const Element &element, Phase &phase) const;
    double target(const Phase &phase, std::size_t joint, const Timeline::Moment &moment) const;

    double m_stepSize, m_gain;
    std::vector<JointMotor> m_motors;
    std::vector<Phase> m_phases;
    Timeline m_timeline;
    Numbers m_targets;      // of the last frame
    Numbers m_phaseStarts;  // of the last frame before the current phase
};

}  // namespace worlds
