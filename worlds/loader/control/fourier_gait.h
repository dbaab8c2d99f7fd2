// Holds joints at angles, and swings some along sums of sines.
//
//   <plugin name="trot" filename="odemt-fourier-gait">
//     <gain>10</gain>                             1/s; speed = gain · (target - angle)
//     <hold joint="neck">-1.57</hold>             rad
//     <start>1</start>                            s; swinging joints are held at 0 before
//     <frequency>1.5</frequency>                  Hz
//     <wave name="hip">
//       <constant>-0.56</constant>                rad
//       <cos>0.59 0.12</cos> <sin>-0.08</sin>     rad, of φ, 2φ, 3φ …
//     </wave>
//     <swing joint="front_left" wave="hip" phase="0.5"/>
//   </plugin>
//
// φ = 2π (frequency · (t - start) + phase). The speed is cut to the joint's <velocity>.
#pragma once

#include "loader/control/controller.h"

#include <map>

namespace worlds {

class FourierGait : public Controller {
public:
    FourierGait(const Element &parameters, const FindMotor &findMotor, double stepSize);
    void update(long frame) override;

private:
    struct Wave {
        double constant;
        std::vector<double> cosines, sines;
        double at(double phase) const;
    };
    struct Hold {
        JointMotor motor;
        double angle;
    };
    struct Swing {
        JointMotor motor;
        const Wave *wave;
        double phase;  // turns
    };

    static Wave readWave(const Element &element);
    void readSwing(const Element &element, const FindMotor &findMotor);
    void approach(JointMotor &motor, double angle) const;

    double m_stepSize, m_gain, m_start, m_frequency;
    std::map<std::string, Wave> m_waves;
    std::vector<Hold> m_holds;
    std::vector<Swing> m_swings;
};

}  // namespace worlds
