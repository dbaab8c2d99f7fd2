// How a collision shape behaves in contact: SDF's <surface>, in the terms of ODE.
#pragma once

#include "loader/description/geometry.h"

#include <optional>
#include <string>

namespace worlds {

struct Surface {
    double mu = 1, mu2 = 1;       // Coulomb friction along the first and second friction direction
    double slip1 = 0, slip2 = 0;  // m/(N·s), force-dependent slip
    std::optional<Vector3> frictionDirection;  // the first one, in the shape's frame,
    std::string frictionFrame;                                  // or in that of this link of the same model

    double restitution = 0;
    double bounceThreshold = 100000;  // m/s, SDF's default: no bounce

    // Unset: the world's ERP and CFM hold for the contact.
    std::optional<double> softErp, softCfm;

    // Two shapes may touch when one's category matches the other's collide mask.
    unsigned short category = 0xffff, collide = 0xffff;
};

}  // namespace worlds
