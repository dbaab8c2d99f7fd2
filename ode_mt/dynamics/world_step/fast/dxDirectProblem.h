// An island's linear complementarity problem in body space: the same problem as dxWorldStepProblem's, without the matrix
// A = J inv(M) J' + cfm/h, whose memory and time grow with the square and the cube of the number of rows.
//
// Its solution x makes these the minimum over changes u of all bodies' velocities per step size (accelerations):
//
//   F(u) = 1/2 u' M u + sum of p(i)(b(i) - J(i) u),  x(i) = p(i)' = clamp((b(i) - J(i) u) / c(i), lo(i), hi(i)),  M u = J' x
//
// which is strictly convex and piecewise quadratic: p(i) is quadratic between the limits and linear beyond them. With
// w(i) = J(i) u + c(i) x(i) - b(i) the clamping is w(i) >= 0 at lo(i), w(i) <= 0 at hi(i) and w(i) = 0 between them, as upstream has it.
//
// Invariants: bodies that no force moves (kinematic ones, the world) are none. Bodies are numbered by their place in the elimination
// order. Rows of the same two bodies stand side by side: a manifold. All numbers are doubles, whatever dReal is.
// Units: those of the user's world.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"

// Rows that act on the same one or two bodies.
struct dxManifold {
    static constexpr unsigned kNoBody = ~0u;

    unsigned firstRow, endRow;
    unsigned body[2];  // the first one is eliminated before the second; kNoBody: none
    unsigned block;    // of the factorisation, for two bodies: row body[1], column body[0]
};

struct dxDirectProblem {
    static constexpr int kNoNormal = -1;

    unsigned bodyCount = 0, rowCount = 0;
    dxBodyBlocks mass;         // M, by body
    dxBodyBlocks inverseMass;  // inv(M)
    std::vector<dxManifold> manifolds;

    // --- rows ---------------------------------------------------------------------------------------------
    dxBodyVectors jacobian;         // two for each row, for the manifold's bodies; 0 where there is none
    std::vector<double> b, c;       // the right-hand side, cfm/h
    std::vector<double> lo, hi;     // of friction rows relative to the normal's force
    std::vector<int> normalOf;      // for friction rows the row of the normal, else kNoNormal
    std::vector<double> diagonal;   // J inv(M) J' of each row

    bool isFriction(unsigned row) const { return normalOf[row] != kNoNormal; }

    // c, or the least of it, as part of the diagonal, with which rows are solved; corrections make up for the difference.
    double softnessOf(unsigned row) const { return std::max(c[row], kMinSoftness * diagonal[row]); }
    static constexpr double kMinSoftness = 1e-12;

    // Whether c counts beside the diagonal.
    static bool isSoft(double c, double diagonal) { return c > kMinSoftness * diagonal; }
};
