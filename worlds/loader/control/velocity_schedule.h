// Piecewise constant motor speeds.
//
//   <plugin name="drive" filename="odemt-velocity-schedule">
//     <joints>left right</joints>              whose speeds the phases give, in this order
//     <phase duration="0.5">0 0</phase>        s; rad/s or m/s
//     <repeat count="3"> … </repeat>           phases and repeats, so many times
//     <repeat> … </repeat>                     without count: endless, so it comes last
//   </plugin>
//
// Durations are rounded to whole steps. After the last phase its speeds stay.
#pragma once

#include "loader/control/controller_registry.h"

namespace worlds {

class VelocitySchedule : public Controller {
public:
    VelocitySchedule(const Parameters &parameters, const FindMotor &findMotor, double stepSize);
    void update(long frame) override;

private:
    struct Phase {
        long end;  // first frame after it
        std::vector<double> speeds;
    };

    void append(const Parameters &list, double stepSize, bool outermost);
    void appendPhase(const Parameters &phase, double stepSize);
    void appendRepeat(const Parameters &repeat, double stepSize, bool outermost);

    std::vector<JointMotor> m_motors;
    std::vector<Phase> m_phases;
    std::size_t m_loopStart = 0;  // the phases from here on are repeated endlessly,
    bool m_loops = false;         // if this is set
    std::size_t m_current = 0;
    long m_loopedFrames = 0;  // frames of the rounds that are over
};

}  // namespace worlds
