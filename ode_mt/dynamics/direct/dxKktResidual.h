// How far a solution is from the conditions of Karush, Kuhn and Tucker that define it (dxDirectProblem.h), in units of w: a
// change of velocity per step size.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// Of one row. Where it may not move at all, any w is right.
inline double dxKktResidual(double x, double w, double low, double high) {
    if (low == high) return 0;
    if (x <= low) return std::max(0.0, -w);
    if (x >= high) return std::max(0.0, w);
    return std::fabs(w);
}

// A force next to a limit, as rounding may leave it, is at the limit.
inline double dxSnapToLimit(double x, double low, double high) {
    constexpr double kNear = 1e-9;  // as part of the limit
    for (const double limit : {low, high})
        if (std::isfinite(limit) && std::fabs(x - limit) <= kNear * std::fabs(limit)) x = limit;
    return x;
}

// Of the worst row, where `s` = -w; infinity if one is no number.
inline double dxWorstKktResidual(const std::vector<double> &x, const std::vector<double> &s, const std::vector<double> &low,
                                 const std::vector<double> &high) {
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double residual = dxKktResidual(x[i], -s[i], low[i], high[i]);
        if (!(residual <= worst)) worst = residual;
    }
    return std::isfinite(worst) ? worst : std::numeric_limits<double>::infinity();
}
