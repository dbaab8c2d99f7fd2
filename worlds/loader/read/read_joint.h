// <joint> with its axes, limits and ODE parameters.
#pragma once

#include "loader/description/joint.h"
#include "loader/read/reading.h"

#include <sdf/Joint.hh>

#include <functional>
#include <optional>

namespace worlds {

// The number of a link, by its name within the joint's model.
using LinkNumber = std::function<int(const std::string &name)>;

// `name` is the joint's in the world, `modelPose` its model's. None when the type is not supported.
std::optional<Joint> readJoint(const sdf::Joint &joint, const std::string &name,
                               const ignition::math::Pose3d &modelPose, const LinkNumber &linkNumber,
                               const Reading &reading);

}  // namespace worlds
