// What a stepper does with a body before it asks the joints: gravity, gyroscopic torque, and inertia in the world's frame.
//
// Threading: different bodies by different threads.
#pragma once

#include <ode/odemath.h>

#include "config.h"
#include "objects.h"

#include "dynamics/step/islands/dxIslandProblem.h"

// Clears the body's accumulators.
inline void dxClearForces(dxBody &body) {
    dZeroVector3(body.facc);
    dZeroVector3(body.tacc);
}

// Adds gravity, where it is not 0, to the body's accumulator, unless the body is in no-gravity mode.
void dxAddGravity(dxBody &body, const dReal *gravity);

// Sets `inverse` (3 rows of 4, the fourth column left alone) to the body's inverse inertia in the world's frame.
void dxFindInvInertia(const dxBody &body, dReal *inverse);

// The body's masses in the world's frame.
void dxFindMasses(const dxBody &body, dxIslandBody &masses);

// Adds the torque of a body that turns about an axis which is no principal one to its accumulator, integrated implicitly over a step
// of `stepSize` seconds. Nothing for bodies without the gyroscopic mode and for kinematic ones.
// Source: C. Lacoursière, "Stabilizing gyroscopic forces in rigid multibody simulations", 2006.
void dxAddGyroscopicTorque(dxBody &body, dReal stepSize);
