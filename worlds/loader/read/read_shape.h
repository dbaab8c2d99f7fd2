// <geometry> of a collision.
#pragma once

#include "loader/description/shape.h"
#include "loader/read/reading.h"

#include <sdf/Geometry.hh>

#include <optional>

namespace worlds {

// None for <empty/> and for geometry that is not supported.
std::optional<Shape> readShape(const sdf::Geometry &geometry, bool isStatic, const Reading &reading);

// Where the shape sits in the collision's frame: off the origin for a height map with <pos>.
ignition::math::Vector3d shapeOffset(const sdf::Geometry &geometry);

}  // namespace worlds
