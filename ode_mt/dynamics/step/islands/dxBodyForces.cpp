#include "dynamics/step/islands/dxBodyForces.h"

#include <ode/odemath.h>
#include <ode/rotation.h>

#include <algorithm>

namespace {

// rotation * tensor * rotation'
void rotateTensor(const dReal *tensor, const dReal *rotation, dReal *rotated) {
    dMatrix3 half;
    dMultiply2_333(half, tensor, rotation);
    dMultiply0_333(rotated, rotation, half);
}

}  // namespace

void dxAddGravity(dxBody &body, const dReal *gravity) {
    if ((body.flags & dxBodyNoGravity) != 0) return;
    for (int axis = 0; axis < 3; ++axis)
        if (gravity[axis] != 0) body.facc[axis] += body.mass.mass * gravity[axis];
}

void dxFindInvInertia(const dxBody &body, dReal *inverse) { rotateTensor(body.invI, body.posr.R, inverse); }

void dxFindMasses(const dxBody &body, dxIslandBody &masses) {
    dMatrix3 inverse;
    dxFindInvInertia(body, inverse);
    for (int row = 0; row < 3; ++row) std::copy_n(inverse + 4 * row, 3, masses.invInertia + 3 * row);
    masses.invMass = body.invMass;
}

// With the angular momentum L = I w, the implicit step solves (I - h [L]) w' = I w, so that the torque is
// (I inv(I - h [L]) - 1) L / h.
void dxAddGyroscopicTorque(dxBody &body, dReal stepSize) {
    if ((body.flags & dxBodyGyroscopic) == 0 || !(body.invMass > 0)) return;
    dMatrix3 inertia;
    rotateTensor(body.mass.I, body.posr.R, inertia);
    dVector3 momentum;
    dMultiply0_331(momentum, inertia, body.avel);

    dMatrix3 system = {0};
    dSetCrossMatrixMinus(system, momentum, 4);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const int i = 4 * row + column;
            system[i] = system[i] * stepSize + inertia[i];
        }
    dMatrix3 inverse;
    if (dInvertMatrix3(inverse, system) == 0) return;
    dMatrix3 change;
    dMultiply0_333(change, inertia, inverse);
    for (int i = 0; i < 3; ++i) change[4 * i + i] -= 1;
    dScaleVector3(momentum, dRecip(stepSize));
    dVector3 torque;
    dMultiply0_331(torque, change, momentum);
    dAddVectors3(body.tacc, body.tacc, torque);
}
