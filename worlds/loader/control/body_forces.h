// Forces on a link that do not come from joints or contacts: thrust in phases, drag, and the righting moment of
// what floats with its centre of mass below its centre of buoyancy.
//
//   <plugin name="flight" filename="odemt-body-forces">
//     <link>hull</link>
//     <linear_drag>0 0 0 0.005 0.0079 0.0079</linear_drag>     N·s/m three times, N·m·s three times
//     <quadratic_drag>0.07 0.28 0.22 0 0 0</quadratic_drag>    N·s²/m², N·m·s²
//     <righting_moment>0.2</righting_moment>                   N·m, when the link lies on its side
//     <phase duration="2">0.04 0 0 0 0.006 0</phase>           s; force in N, torque in N·m
//     <repeat> … </repeat>                                     Timeline
//   </plugin>
//
// Six numbers are those along the link's x, y and z axes and those about them; forces act at the centre of mass.
// Drag is never more than what stops the link within the step (damped_body.h). It is 0 unless given, and so is
// the righting moment, which turns the link's z axis upwards. No other controller pushes the link.
#pragma once

#include "loader/control/damped_body.h"
#include "loader/control/schedule.h"

#include <array>

namespace worlds {

class BodyForces : public Controller {
public:
    BodyForces(const Element &parameters, const FindBody &findBody, double stepSize);
    void update(long frame) override;

private:
    using Wrench = std::array<double, 6>;

    static Wrench toWrench(const std::vector<double> &numbers);
    static Wrench readDrag(const Element &parameters, const std::string &name);

    DampedBody m_body;
    Wrench m_linearDrag, m_quadraticDrag;
    double m_rightingMoment;
    std::vector<Wrench> m_thrusts;  // of each phase
    Timeline m_timeline;
};

}  // namespace worlds
