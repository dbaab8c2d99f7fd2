// One row of the problem that a step solves, in units of velocity: with the velocities v that the step gives the bodies and the row's
// force x, w = J v - c + cfm x; lo <= x <= hi, where w >= 0 at lo, w <= 0 at hi, and w = 0 between.
//
// Rows follow ODE's documented meaning of contacts and joints, written down anew from upstream's formulas, so that they know
// nothing of the library that is judged.
#pragma once

#include <ode/ode.h>

namespace quality {

struct ConstraintRow {
    static constexpr int kNone = -1;

    int body[2] = {kNone, kNone};  // places in the list of bodies
    double jacobian[2][6] = {};    // linear, angular
    double c = 0;                  // m/s or rad/s
    double cfm = 0;
    double low = -dInfinity, high = dInfinity;  // N or N m; of a friction row with a normal, factors of the normal's force
    int normalRow = kNone;         // place of the row whose force limits this one
    double force = 0;              // x, which joint feedback tells
};

}  // namespace quality
