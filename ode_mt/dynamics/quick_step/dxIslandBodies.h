// QuickStep's stages over the bodies of an island.
#pragma once

#include "dynamics/step/islands/dxBodyMotion.h"
#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxIslandStep.h"

// Numbers the bodies (dObject::tag), adds gravity and gyroscopic torques to their accumulators, and finds their masses in the
// world's frame. Parallel: writes each body, and its entry in `bodies`.
void dxGatherBodies(const dxIslandStep &step, dxIslandBody *bodies);

// Sets problem.accelerations to -(v / h + inv(M) f). Not before all joints have been asked: motors push their bodies. Parallel:
// reads bodies.
void dxFindFreeAccelerations(const dxIslandStep &step, const dxIslandProblem &problem);

// Integrates forces and the constraints' `accelerations`, which may be null, to velocities. Parallel: writes bodies.
void dxIntegrateVelocities(const dxIslandStep &step, const dxIslandBody *bodies, const dxSpatialMotion *accelerations,
                           dxNotificationPolicy &notifications);
