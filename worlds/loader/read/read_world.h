// A whole world, from libsdformat's objects to plain data.
#pragma once

#include "loader/description/world_description.h"
#include "loader/read/issues.h"
#include "loader/read/resource_finder.h"

#include <sdf/World.hh>

namespace worlds {

// Throws LoadError.
WorldDescription readWorld(const sdf::World &world, const std::string &worldFile,
                           const ResourceFinder &resources, const Issues &issues);

}  // namespace worlds
