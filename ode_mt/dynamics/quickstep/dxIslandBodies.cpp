#include "dynamics/quickstep/dxIslandBodies.h"

#include <ode/odemath.h>

#include "dynamics/islands/dxBodyIntegration.h"
#include "dynamics/islands/dxIslandPrefetch.h"
#include "dynamics/islands/dxBodyForces.h"

namespace {

// Bodies that one worker takes at once: some ten microseconds.
constexpr std::size_t kBodiesPerJob = 32;

// Calls work(i) for the bodies [begin, end). In an island that does not fit L2, the next bodies are prefetched, up to number
// `fetchEnd`.
template <class Work>
void forBodies(const dxIslandStep &step, std::size_t begin, std::size_t end, std::size_t fetchEnd, const Work &work) {
    if (step.island.bodyCount < dxIslandPrefetch::kMinBodies) {
        for (std::size_t i = begin; i < end; ++i) work(i);
        return;
    }
    dxBody *const *const bodies = step.island.bodies;
    dxIslandPrefetch::forChunks(begin, end, fetchEnd, [bodies](std::size_t i) { dxIslandPrefetch::body(bodies[i]); },
                            [&work](std::size_t first, std::size_t last) {
                                for (std::size_t i = first; i < last; ++i) work(i);
                            });
}

template <class Work>
void forAllBodies(const dxIslandStep &step, const Work &work) {
    forBodies(step, 0, step.island.bodyCount, step.island.bodyCount, work);
}

// As above, on the island's workers. What lies beyond a job may be another worker's and is not fetched.
template <class Work>
void forBodiesInParallel(const dxIslandStep &step, dxParallelStage stage, const Work &work) {
    if (step.islandWorkers == nullptr) return forAllBodies(step, work);
    step.runner().forChunks(stage, step.island.bodyCount, kBodiesPerJob,
                            [&](std::size_t begin, std::size_t end, unsigned) { forBodies(step, begin, end, end, work); });
}

// Sums in the order of upstream's dMultiply0_331.
void multiply(dReal *result, const dReal *matrix, const dReal *vector) {
    for (int row = 0; row < 3; ++row)
        result[row] = matrix[3 * row] * vector[0] + matrix[3 * row + 1] * vector[1] + matrix[3 * row + 2] * vector[2];
}

}  // namespace

void dxGatherBodies(const dxIslandStep &step, dxIslandBody *bodies) {
    const dReal *const gravity = step.world->gravity;
    forBodiesInParallel(step, dxParallelStage::Bodies, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        body.tag = static_cast<int>(i);
        dxAddGravity(body, gravity);
        dMatrix3 invInertia;
        dxFindInvInertia(body, invInertia);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) bodies[i].invInertia[3 * row + column] = invInertia[4 * row + column];
        bodies[i].invMass = body.invMass;
        dxAddGyroscopicTorque(body, step.stepSize);
    });
}

void dxFindFreeAccelerations(const dxIslandStep &step, const dxIslandProblem &problem) {
    const dReal perStep = dRecip(step.stepSize);
    forBodiesInParallel(step, dxParallelStage::RightHandSides, [&](std::size_t i) {
        const dxBody &body = *step.island.bodies[i];
        dReal *const linear = problem.accelerations[i].columns, *const angular = linear + 3;
        for (int axis = 0; axis < 3; ++axis)
            linear[axis] = -(body.facc[axis] * body.invMass + body.lvel[axis] * perStep);
        dReal turned[3];
        multiply(turned, problem.bodies[i].invInertia, body.tacc);
        for (int axis = 0; axis < 3; ++axis) angular[axis] = -(body.avel[axis] * perStep) - turned[axis];
    });
}

void dxIntegrateVelocities(const dxIslandStep &step, const dxIslandBody *bodies, const dxBodyAcceleration *accelerations) {
    const dReal h = step.stepSize;
    forAllBodies(step, [&](std::size_t i) {
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
    });
}

void dxMoveBodies(const dxIslandStep &step) {
    forAllBodies(step, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        dxIntegrateIslandBody(&body, step.stepSize);
        dZeroVector3(body.facc);
        dZeroVector3(body.tacc);
    });
}
