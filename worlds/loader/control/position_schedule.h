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
//     <repeat> … </repeat>                           timeline.h
//   </plugin>
//
// The speed is cut to the joint's <velocity>.
#pragma once

#include "loader/control/timeline.h"

namespace worlds {

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
