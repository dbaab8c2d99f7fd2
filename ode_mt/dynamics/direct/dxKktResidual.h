// How far a solution is from the conditions of Karush, Kuhn and Tucker that define it (dxDirectProblem.h), in units of w: a
// change of velocity per step size.
#pragma once

#include <algorithm>
#include <cmath>

// Of one row. Where it may not move at all, any w is right.
inline double dxKktResidual(double x, double w, double low, double high) {
    if (low == high) return 0;
    if (x <= low) return std::max(0.0, -w);
    if (x >= high) return std::max(0.0, w);
    return std::fabs(w);
}
