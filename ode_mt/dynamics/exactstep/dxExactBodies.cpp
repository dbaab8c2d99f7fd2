#include "dynamics/exactstep/dxExactBodies.h"

#include <ode/odemath.h>

#include "dynamics/exactstep/dxExactProblem.h"

namespace {

constexpr unsigned kInertiaAlignment = 32;  // bytes

void addGravity(dxBody &body, const dReal *gravity) {
    if ((body.flags & dxBodyNoGravity) != 0) return;
    for (unsigned axis = dSA__MIN; axis != dSA__MAX; ++axis)
        if (gravity[axis] != 0) body.facc[axis] += body.mass.mass * gravity[axis];
}

// R I R'
void turnIntoWorld(const dReal *R, const dReal *inertia, dReal *turned) {
    dMatrix3 half;
    dMultiply2_333(half, inertia, R);
    dMultiply0_333(turned, R, half);
}

// The torque of an implicit step, which is stable (Lacoursière 2006, "Stabilizing Gyroscopic Forces in Rigid Multibody
// Simulations"): with the angular momentum L = I w and the tensor T = I - h [L x], it is (I inv(T) - 1) L/h.
void addGyroscopicTorque(dxBody &body, dReal stepSize) {
    dMatrix3 inertia = {0}, tensor = {0}, inverse;
    turnIntoWorld(body.posr.R, body.mass.I, inertia);
    dVector3 momentum;
    dMultiply0_331(momentum, inertia, body.avel);

    dSetCrossMatrixMinus(tensor, momentum, dV3E__MAX);
    for (unsigned i = dM3E__MIN; i != dM3E__MAX; ++i) tensor[i] = tensor[i] * stepSize + inertia[i];
    if (dInvertMatrix3(inverse, tensor) == 0) return;
    dScaleVector3(momentum, dRecip(stepSize));

    dMultiply0_333(tensor, inertia, inverse);
    for (const unsigned diagonal : {dM3E_XX, dM3E_YY, dM3E_ZZ}) tensor[diagonal] -= 1;
    dVector3 torque;
    dMultiply0_331(torque, tensor, momentum);
    for (unsigned axis = dSA__MIN; axis != dSA__MAX; ++axis) body.tacc[axis] += torque[axis];
}

// A kinematic body has no mass.
bool isGyroscopic(const dxBody &body) { return (body.flags & dxBodyGyroscopic) != 0 && body.invMass > 0; }

}  // namespace

void dxGatherBodies(const dxStepperProcessingCallContext &island, dxExactProblem &problem) {
    problem.bodies = island.m_islandBodiesStart;
    problem.bodyCount = island.m_islandBodiesCount;
    problem.inverseInertia =
        island.m_stepperArena->AllocateOveralignedArray<dxInverseInertia>(problem.bodyCount, kInertiaAlignment);
    const dReal *const gravity = island.m_world->gravity;
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        dxBody &body = *problem.bodies[i];
        body.tag = static_cast<int>(i);
        addGravity(body, gravity);
        turnIntoWorld(body.posr.R, body.invI, problem.inverseInertia[i].tensor);
        if (isGyroscopic(body)) addGyroscopicTorque(body, island.m_stepSize);
    }
}
