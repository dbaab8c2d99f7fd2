// How far a step's forces and velocities are from the solution that the rows define.
//
// A row's error is how much its own force would have to change for its own condition to hold, all other forces as they are:
//
//     d = x - clamp(x - w / a, lo, hi),   a = h J inv(M) J' + cfm
//
// where w is the row's velocity error and a friction row's limits follow from the normal's force as it is (upstream's QuickStep
// has the same). a d is a velocity: what is left to do of a Gauss-Seidel step. It is 0 for all rows at the solution and nowhere else.
#pragma once

#include "body_state.h"
#include "constraint_row.h"

#include <vector>

namespace quality {

struct Velocity {
    double axis[6];  // linear, angular
};

struct Residual {
    double worst = 0;   // largest |a d|; m/s or rad/s
    double energy = 0;  // of all d together: sum of (a d)^2 h / 2 a; J
    int rows = 0;
};

// `velocities` are those after the step, by body.
Residual residualOf(const std::vector<ConstraintRow> &rows, const std::vector<InverseInertia> &inertias,
                    const std::vector<Velocity> &velocities, double stepSize);

}  // namespace quality
