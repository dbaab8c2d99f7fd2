// <link> with its inertia and collision shapes.
#pragma once

#include "loader/description/link.h"
#include "loader/read/reading.h"

#include <sdf/Link.hh>
#include <sdf/Model.hh>

namespace worlds {

// `name` and `modelPose` are those of the model in the world.
Link readLink(const sdf::Link &link, const sdf::Model &model, const std::string &name,
              const ignition::math::Pose3d &modelPose, bool isStatic, const Reading &reading);

}  // namespace worlds
