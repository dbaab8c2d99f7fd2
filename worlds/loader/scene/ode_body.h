// A body from a link that moves.
#pragma once

#include "loader/description/link.h"

#include <ode/ode.h>

namespace worlds {

// ODE wants a body's origin in its centre of mass; its axes are the link's.
dBodyID createBody(dWorldID world, const Link &link);

}  // namespace worlds
