// An ODE joint from a joint of a description.
#pragma once

#include "loader/description/world_description.h"

#include <ode/ode.h>

namespace worlds {

// A null body is the static world. Null when neither body moves. Throws LoadError.
dJointID createJoint(dWorldID world, const Joint &joint, dBodyID parent, dBodyID child);

}  // namespace worlds
