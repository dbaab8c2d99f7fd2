#include "dynamics/quick_step/dxIslandBodies.h"

#include <ode/odemath.h>

#include "dynamics/step/islands/dxBodyForces.h"
#include "dynamics/step/islands/dxForBodies.h"

namespace {

// Sums in the order of upstream's dMultiply0_331.
void multiply(dReal *result, const dReal *matrix, const dReal *vector) {
    for (int row = 0; row < 3; ++row)
        result[row] = matrix[3 * row] * vector[0] + matrix[3 * row + 1] * vector[1] + matrix[3 * row + 2] * vector[2];
}

}  // namespace

void dxGatherBodies(const dxIslandStep &step, dxIslandBody *bodies) {
    const dReal *const gravity = step.world->gravity;
    dxForBodiesInParallel(step, dxParallelStage::Bodies, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        body.tag = static_cast<int>(i);
        dxAddGravity(body, gravity);
        dxFindMasses(body, bodies[i]);
        dxAddGyroscopicTorque(body, step.stepSize);
    });
}

void dxFindFreeAccelerations(const dxIslandStep &step, const dxIslandProblem &problem) {
    const dReal perStep = dRecip(step.stepSize);
    dxForBodiesInParallel(step, dxParallelStage::RightHandSides, [&](std::size_t i) {
        const dxBody &body = *step.island.bodies[i];
        dReal *const linear = problem.accelerations[i].columns, *const angular = linear + 3;
        for (int axis = 0; axis < 3; ++axis)
            linear[axis] = -(body.facc[axis] * body.invMass + body.lvel[axis] * perStep);
        dReal turned[3];
        multiply(turned, problem.bodies[i].invInertia, body.tacc);
        for (int axis = 0; axis < 3; ++axis) angular[axis] = -(body.avel[axis] * perStep) - turned[axis];
    });
}

void dxIntegrateVelocities(const dxIslandStep &step, const dxIslandBody *bodies, const dxSpatialMotion *accelerations,
                           dxNotificationPolicy &notifications) {
    const dReal h = step.stepSize;
    dxForBodiesInParallel(step, dxParallelStage::Motion, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        if (accelerations != nullptr) {
            const dReal *const own = accelerations[i].columns;
            for (int axis = 0; axis < 3; ++axis) {
                body.lvel[axis] += h * own[axis];
                body.avel[axis] += h * own[3 + axis];
            }
        }
        const dReal perForce = h * body.invMass;
        for (int axis = 0; axis < 3; ++axis) {
            body.lvel[axis] += perForce * body.facc[axis];
            body.tacc[axis] *= h;
        }
        dReal turned[3];
        multiply(turned, bodies[i].invInertia, body.tacc);
        dAddVectors3(body.avel, body.avel, turned);
        notifications.add(body);
    });
}
