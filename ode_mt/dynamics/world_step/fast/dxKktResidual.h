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

// The residual of the worst row; infinity if a w is not finite, as it is where a force is not: a comparison may drop what is no number.
class dxWorstResidual {
public:
    void add(double residual, double w) {
        m_worst = std::max(m_worst, residual);
        m_zero += w * 0;
    }
    double get() const { return m_zero == 0 ? m_worst : std::numeric_limits<double>::infinity(); }

private:
    double m_worst = 0, m_zero = 0;
};

// `s` = -w.
inline double dxWorstKktResidual(const std::vector<double> &x, const std::vector<double> &s, const std::vector<double> &low,
                                 const std::vector<double> &high) {
    dxWorstResidual worst;
    for (std::size_t i = 0; i < x.size(); ++i) worst.add(dxKktResidual(x[i], -s[i], low[i], high[i]), s[i]);
    return worst.get();
}
