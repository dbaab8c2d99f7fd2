// Piecewise constant motor speeds.
//
//   <plugin name="drive" filename="odemt-velocity-schedule">
//     <joints>left right</joints>              whose speeds the phases give, in this order
//     <phase duration="0.5">0 0</phase>        s; rad/s or m/s
//     <repeat> … </repeat>                     timeline.h
//   </plugin>
#pragma once

#include "loader/control/timeline.h"

namespace worlds {

class VelocitySchedule : public Controller {
public:
    VelocitySchedule(const Element &parameters, const FindMotor &findMotor, double stepSize);
    void update(long frame) override;

private:
    std::vector<JointMotor> m_motors;
    std::vector<std::vector<double>> m_speeds;  // of each phase
    Timeline m_timeline;
};

}  // namespace worlds
