// ODE's world and space from the physics of a description.
#pragma once

#include "loader/description/physics.h"

#include <ode/ode.h>

namespace worlds {

dWorldID createWorld(const Physics &physics);
dSpaceID createSpace(const Space &space);

}  // namespace worlds
