// <joint> with its axes, limits and ODE parameters.
#pragma once

#include "loader/description/world_description.h"
#include "loader/read/frames.h"
#include "loader/read/reading.h"

namespace worlds {

// Null: the world.
struct JointedBodies {
    Body parent, child;
};
// Throws LoadError when a joint of `model` joins nothing, or a link to itself.
JointedBodies readJointedBodies(const Element &joint, const Scope &model);

// `name` is the joint's in the world, `modelPose` its model's. Links are left to the caller.
Joint readJoint(const Element &joint, const Scope &model, const std::string &name, const Pose &modelPose,
                const Reading &reading);

}  // namespace worlds
