#include "dynamics/exactstep/dxExactBodies.h"

#include <ode/odemath.h>

#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/islands/dxBodyForces.h"

namespace {

constexpr unsigned kInertiaAlignment = 32;  // bytes

}  // namespace

void dxGatherBodies(const dxIslandStep &step, dxExactProblem &problem) {
    problem.bodies = step.island.bodies;
    problem.bodyCount = step.island.bodyCount;
    problem.inverseInertia =
        step.arena->AllocateOveralignedArray<dxInverseInertia>(problem.bodyCount, kInertiaAlignment);
    const dReal *const gravity = step.world->gravity;
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        dxBody &body = *problem.bodies[i];
        body.tag = static_cast<int>(i);
        dxAddGravity(body, gravity);
        dxFindInvInertia(body, problem.inverseInertia[i].tensor);
        dxAddGyroscopicTorque(body, step.stepSize);
    }
}
