// Cycles of a fixed length, parted in two at a random point: motor speeds of the one part, then of the
// other.
//
//   <plugin name="player" filename="odemt-random-cycle">
//     <joints>left right</joints>
//     <control_step>0.064</control_step>   s; the unit of the lengths below
//     <cycle>100</cycle>                   length of a cycle
//     <first_part start="49" least="29" most="98">10 10</first_part>
//     <second_part>-10 10</second_part>
//     <seed>147</seed>
//   </plugin>
//
// The first part takes `start` control steps in the first cycle. In each later one it takes
// least + r % (most - least + 1), r being the next number of std::minstd_rand, the generator
// x' = 48271 x mod (2³¹ - 1) that the C++ standard defines to the last bit.
#pragma once

#include "loader/control/controller.h"

#include <random>

namespace worlds {

class RandomCycle : public Controller {
public:
    RandomCycle(const Element &parameters, const FindMotor &findMotor, double stepSize);
    void update(long frame) override;

private:
    std::vector<JointMotor> m_motors;
    std::vector<double> m_firstSpeeds, m_secondSpeeds;
    long m_framesPerStep;           // frames of one control step
    long m_cycle, m_least, m_most;  // control steps
    long m_firstPart;               // of the current cycle
    long m_cycleStart = 0;          // frame
    std::minstd_rand m_random;
};

}  // namespace worlds
