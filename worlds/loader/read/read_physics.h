// <gravity> and <physics> of a world.
#pragma once

#include "loader/description/physics.h"
#include "loader/read/issues.h"

#include <sdf/World.hh>

namespace worlds {

Physics readPhysics(const sdf::World &world, const std::string &worldFile);

}  // namespace worlds
