// Forces of a fluid at rest on links of the model: the lift of what is immersed, and drag.
//
//   <plugin name="water" filename="odemt-fluid">
//     <surface>0</surface>                        m; the fluid is below this height
//     <density>1000</density>                     kg/m³
//     <immersed link="tail">
//       <size>0.09 0.04 0.06</size>               m; the box that the link displaces, along its axes
//       <center>0.01 0 0.014</center>             m; of the box, from the centre of mass; 0 unless given
//       <drag>0 3.1 1.3</drag>                    drag coefficients along the axes, 0 unless given
//       <spin_drag>1e-4</spin_drag>               N·m·s, 0 unless given
//     </immersed>
//   </plugin>
//
// Lift is the weight of the fluid in the share of the box that is below the surface: that of its height, as
// if the box were upright. It acts at the box's centre, and so does drag, ½ · density · coefficient · side ·
// speed² along each axis, times the share, and never more than what stops the link within the step (damped_body.h).
// A link is immersed once, and no other controller pushes it.
#pragma once

#include "loader/control/controller.h"
#include "loader/control/damped_body.h"

#include <array>

namespace worlds {

class Fluid : public Controller {
public:
    Fluid(const Element &parameters, const FindBody &findBody, double stepSize);
    void update(long frame) override;

private:
    using Vector = std::array<double, 3>;
    struct Immersed {
        DampedBody body;
        Vector size, center, drag;  // drag in N·s²/m², of the whole box
        double spinDrag;
    };

    Immersed readImmersed(const Element &element, const FindBody &findBody) const;
    double share(const Immersed &link) const;
    void push(Immersed &link) const;

    double m_stepSize, m_surface, m_density;
    std::vector<Immersed> m_links;
};

}  // namespace worlds
