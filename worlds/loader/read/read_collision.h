// <collision> of a link, with its geometry and surface.
#pragma once

#include "loader/description/world_description.h"
#include "loader/read/reading.h"

#include <optional>

namespace worlds {

// `pose` is that of the collision in its link. None for <empty/> and for a shape that is not supported.
// Throws LoadError.
std::optional<Collision> readCollision(const Element &element, const Pose &pose, bool isStatic,
                                       const Physics &physics, const Reading &reading);

// What is not written stays as in `base`. The step size converts <kp> and <kd> to ERP and CFM.
Surface readSurface(const Element &element, Surface base, double stepSize);

}  // namespace worlds
