#include "dynamics/quick_step/fast/dxFreeMotion.h"

#include <ode/odemath.h>
#include <ode/rotation.h>

#include "dynamics/step/islands/dxBodyForces.h"
#include "dynamics/step/islands/dxForBodies.h"

namespace {

// Adds the torque of dxAddGyroscopicTorque. In the body's frame, with the momentum L = I w, the implicit step solves
// (I - h [L]) w' = L; then (I w' - L) / h, the torque, is L x w'.
void addGyroscopicTorque(const dxBody &body, dReal stepSize, dReal *torque) {
    if ((body.flags & dxBodyGyroscopic) == 0 || !(body.invMass > 0)) return;
    dVector3 velocity, momentum;
    dMultiply1_331(velocity, body.posr.R, body.avel);
    dMultiply0_331(momentum, body.mass.I, velocity);
    const dReal *const inertia = body.mass.I;
    dReal column[3][4];
    for (int i = 0; i < 3; ++i)
        for (int row = 0; row < 3; ++row) column[i][row] = inertia[4 * row + i];
    const dReal x = stepSize * momentum[0], y = stepSize * momentum[1], z = stepSize * momentum[2];
    column[1][0] += z;
    column[2][0] -= y;
    column[0][1] -= z;
    column[2][1] += x;
    column[0][2] += y;
    column[1][2] -= x;
    dVector3 product[3];  // Cramer's rule
    for (int i = 0; i < 3; ++i) dCalcVectorCross3(product[i], column[(i + 1) % 3], column[(i + 2) % 3]);
    const dReal determinant = dCalcVectorDot3(column[0], product[0]);
    if (determinant == 0) return;
    const dReal inverse = dRecip(determinant);
    dVector3 next, own, turned;
    for (int i = 0; i < 3; ++i) next[i] = inverse * dCalcVectorDot3(momentum, product[i]);
    dCalcVectorCross3(own, momentum, next);
    dMultiply0_331(turned, body.posr.R, own);
    dAddVectors3(torque, torque, turned);
}

// Writes v + h inv(M) f.
void findVelocity(const dxIslandStep &step, const dxBody &body, const dxIslandBody &masses, dReal *velocity) {
    const dReal h = step.stepSize, perForce = h * masses.invMass;
    dVector3 force, torque;
    dCopyVector3(force, body.facc);
    dCopyVector3(torque, body.tacc);
    if ((body.flags & dxBodyNoGravity) == 0) dAddVectorScaledVector3(force, force, step.world->gravity, body.mass.mass);
    addGyroscopicTorque(body, h, torque);
    for (int axis = 0; axis < 3; ++axis) {
        const dReal *const inertia = masses.invInertia + 3 * axis;
        velocity[axis] = body.lvel[axis] + perForce * force[axis];
        velocity[3 + axis] = body.avel[axis] + h * (inertia[0] * torque[0] + inertia[1] * torque[1] + inertia[2] * torque[2]);
    }
}

void findMotion(const dxIslandStep &step, std::size_t i, dxIslandBody *masses, dxSpatialMotion *velocities) {
    const dxBody &body = *step.island.bodies[i];
    dxFindMasses(body, masses[i]);
    findVelocity(step, body, masses[i], velocities[i].columns);
}

}  // namespace

void dxFindFreeMotion(const dxIslandStep &step, std::size_t begin, std::size_t end, dxIslandBody *masses, dxSpatialMotion *velocities) {
    dxBodyLoops::forRange(step, begin, end, end, [&](std::size_t i) { findMotion(step, i, masses, velocities); });
}

void dxFindFreeMotion(const dxIslandStep &step, dxIslandBody *masses, dxSpatialMotion *velocities) {
    dxForBodiesInParallel(step, dxParallelStage::Bodies, [&](std::size_t i) { findMotion(step, i, masses, velocities); });
}
