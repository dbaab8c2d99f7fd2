// ODE's world, space and bodies from a description.
#pragma once

#include "loader/description/world_description.h"

#include <ode/ode.h>

namespace worlds {

dWorldID createWorld(const Physics &physics);
dSpaceID createSpace(const Space &space);

// ODE wants a body's origin in its centre of mass; its axes are the link's.
dBodyID createBody(dWorldID world, const Link &link);

}  // namespace worlds
