// The shape of a geom of ODE, as a recording has it.
#pragma once

#include "record/recording.h"

#include <ode/ode.h>

namespace record {

Shape shapeOf(dGeomID geom);
Pose poseOf(dGeomID geom);  // of a plane, which has none: that of the world
Pose poseOf(dBodyID body);
Velocity velocityOf(dBodyID body);

}  // namespace record
