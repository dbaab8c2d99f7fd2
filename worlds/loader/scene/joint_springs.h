// Damping and springs of joint axes: forces added before every step, since ODE's joints have neither.
#pragma once

#include "loader/description/world_description.h"
#include "loader/scene/joint_axis_handle.h"

#include <vector>

namespace worlds {

class JointSprings {
public:
    explicit JointSprings(double stepSize) : m_stepSize(stepSize) {}

    // Takes the axes of a joint that have damping or a spring.
    void add(dJointID joint, const Joint &description);

    // force = -damping * rate - stiffness * (position - reference)
    void apply() const;

private:
    struct Spring {
        JointAxisHandle axis;
        dReal damping, stiffness, reference;
    };

    double m_stepSize;
    std::vector<Spring> m_springs;
};

}  // namespace worlds
