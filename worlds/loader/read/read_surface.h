// <surface> of a collision shape.
#pragma once

#include "loader/description/parameters.h"
#include "loader/description/surface.h"

namespace worlds {

// What is not written stays as in `base`. The step size converts <kp> and <kd> to ERP and CFM.
Surface readSurface(const Parameters &element, Surface base, double stepSize);

}  // namespace worlds
