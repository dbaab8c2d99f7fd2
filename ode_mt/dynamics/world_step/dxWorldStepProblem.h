// One island as dWorldStep solves it: its bodies, its joints that have rows, and the linear complementarity problem
// (LCP) that these make:
//
//   A x = b + w,  lo <= x <= hi,  where w(i) >= 0 if x(i) = lo(i), w(i) <= 0 if x(i) = hi(i), w(i) = 0 otherwise
//
//   A = J inv(M) J' + cfm/h       J  Jacobian, M  mass matrix, cfm  constraint force mixing, h  step size
//   b = c/h - J (v/h + inv(M) f)  c  the joints' right-hand sides, v  velocities, f  external forces
//   x                             the forces of the rows (lambda)
//
// Invariants: joints stand in the order of their rows. A joint's first body is never null. Bodies are numbered by their tags.
// Arrays lie in the arena of the step. Units: those of the user's world.
#pragma once

#include <cstdint>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

#include "dynamics/world_step/kernels/dxConstraintMatrix.h"

// A body's inverse inertia tensor in the world's frame: a 3 x 4 matrix. While the matrix is made, its last column holds the
// inverse mass (dxConstraintMatrix.h).
struct dxInverseInertia {
    dMatrix3 tensor;
};

// A joint that has rows.
struct dxWorldStepJoint {
    dxJoint *joint;
    unsigned firstRow;
    std::uint8_t rows;  // 1 to 6
};

struct dxWorldStepProblem {
    // --- bodies, by tag ---------------------------------------------------------------------------------
    dxBody *const *bodies = nullptr;
    unsigned bodyCount = 0;
    dxInverseInertia *inverseInertia = nullptr;

    // --- joints with rows -------------------------------------------------------------------------------
    const dxWorldStepJoint *joints = nullptr;
    unsigned jointCount = 0;
    unsigned bilateralJoints = 0;  // first joints, all of whose rows are bilateral

    // --- rows; null where there are none ------------------------------------------------------------------
    unsigned rowCount = 0;
    dReal *jacobian = nullptr;   // kElements for each row of a joint on its first body, then for each on its second one
    dReal *pairsBX = nullptr;    // c/h and cfm/h; the solver turns them into b and x
    dReal *pairsLoHi = nullptr;  // lo, hi; of friction rows relative to the normal's force
    int *normalOf = nullptr;     // for friction rows the row of the normal, else -1

    dxBodyLinks::Lists links;    // of each body's joints with rows, the last one first

    // Elements of one row of the Jacobian for one body: linear, then angular.
    static constexpr unsigned kElements = dDA__MAX;
    static constexpr unsigned kSides = dJCB__MAX;

    dReal *rowsOf(const dxWorldStepJoint &joint, unsigned side) const {
        return jacobian + (std::size_t(joint.firstRow) * kSides + std::size_t(side) * joint.rows) * kElements;
    }

    // Returns whether the row is bilateral: it has no limits, neither fixed ones nor those of a normal's force. All others are unilateral:
    // contacts, friction, stops, motors.
    bool isBilateral(std::size_t row) const {
        const dReal *const limits = pairsLoHi + row * dxJoint::GI2__LO_HI_MAX;
        return limits[dxJoint::GI2_LO] == -dInfinity && limits[dxJoint::GI2_HI] == dInfinity && normalOf[row] == -1;
    }
};
