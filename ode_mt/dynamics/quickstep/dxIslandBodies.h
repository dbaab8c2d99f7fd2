// QuickStep's stages over the bodies of an island.
#pragma once

#include "dynamics/islands/dxIslandProblem.h"
#include "dynamics/islands/dxIslandStep.h"

// Numbers the bodies (dObject::tag), adds gravity and gyroscopic torques to their accumulators, and finds their masses in the
// world's frame. Parallel: writes each body, and its entry in `bodies`.
void dxGatherBodies(const dxIslandStep &step, dxIslandBody *bodies);

// Sets problem.accelerations to -(v / h + inv(M) f). Not before all joints have been asked: motors push their bodies. Parallel:
// reads bodies.
void dxFindFreeAccelerations(const dxIslandStep &step, const dxIslandProblem &problem);

// Integrates forces and the constraints' `accelerations`, which may be null, to velocities. Serial: writes bodies.
void dxIntegrateVelocities(const dxIslandStep &step, const dxIslandBody *bodies, const dxBodyAcceleration *accelerations);

// Integrates velocities to positions, tells spaces and the user's callbacks, and clears the accumulators. Serial, in the island's
// order.
void dxMoveBodies(const dxIslandStep &step);
