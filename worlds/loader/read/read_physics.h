// <physics> and <gravity> of a world.
#pragma once

#include "loader/description/element.h"
#include "loader/description/world_description.h"

namespace worlds {

// Requires a world whose elements are checked. Throws LoadError.
Physics readPhysics(const Element &world);

}  // namespace worlds
