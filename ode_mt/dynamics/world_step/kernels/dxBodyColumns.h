// What a step computes of each body alone, for a few bodies at once: inertia in the world's frame, gyroscopic torque, and the turn of a
// step. A lane is a body, and each does what upstream does in upstream's order, so the bits are those of dxFindInvInertia,
// dxAddGyroscopicTorque and dxStepBody for every instruction set.
//
// Columns are filled and read one body after another. Lanes beyond the last body repeat it, so that nothing is computed that no body
// asks for but the torque of bodies without the gyroscopic mode: not for programs that trap floating-point exceptions.
#pragma once

#include <ode/common.h>

#include "core/dxCacheLine.h"

constexpr unsigned kBodyColumns = 16;  // bodies: their columns stay in L1, and what is stored by bodies has arrived when vectors read it

// Matrices by rows.
struct alignas(kCacheLine) dxInertiaColumns {
    // --- given ---------------------------------------------------------------------------------------------
    dReal rotation[9][kBodyColumns];
    dReal tensor[9][kBodyColumns], inverseTensor[9][kBodyColumns];  // in the body's frame
    dReal velocity[3][kBodyColumns];                                // angular

    // --- found -----------------------------------------------------------------------------------------------
    dReal inverse[9][kBodyColumns];      // inverse inertia in the world's frame
    dReal torque[3][kBodyColumns];       // gyroscopic
    dReal determinant[kBodyColumns];     // of the system that has it; 0: there is no torque
};

// Quaternions: real part first.
struct alignas(kCacheLine) dxTurnColumns {
    dReal velocity[3][kBodyColumns];     // given
    dReal orientation[4][kBodyColumns];  // given; then that after the step
    dReal rotation[9][kBodyColumns];     // found
};

// `count`: at most kBodyColumns; columns are filled up to a multiple of 8.
void dxFindInertia(dxInertiaColumns &columns, unsigned count, dReal stepSize);

// Requires orientations of a length. Angular velocities for `stepSize` seconds.
void dxTurnBodies(dxTurnColumns &columns, unsigned count, dReal stepSize);

// Lanes that are filled for `count` bodies.
constexpr unsigned dxFilledColumns(unsigned count) { return (count + 7) / 8 * 8; }
