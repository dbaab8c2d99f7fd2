#include "lcp_residual.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quality {

namespace {

// J inv(M) J' of one row.
double diagonalOf(const ConstraintRow &row, const std::vector<InverseInertia> &inertias) {
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        if (row.body[side] == ConstraintRow::kNone) continue;
        double change[6];
        inertias[std::size_t(row.body[side])].apply(row.jacobian[side], change);
        for (int i = 0; i < 6; ++i) sum += row.jacobian[side][i] * change[i];
    }
    return sum;
}

double velocityOf(const ConstraintRow &row, const std::vector<Velocity> &velocities) {
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        if (row.body[side] == ConstraintRow::kNone) continue;
        for (int i = 0; i < 6; ++i) sum += row.jacobian[side][i] * velocities[std::size_t(row.body[side])].axis[i];
    }
    return sum;
}

}  // namespace

Residual residualOf(const std::vector<ConstraintRow> &rows, const std::vector<InverseInertia> &inertias,
                    const std::vector<Velocity> &velocities, double stepSize) {
    Residual residual;
    residual.rows = int(rows.size());
    for (const ConstraintRow &row : rows) {
        const double a = stepSize * diagonalOf(row, inertias) + row.cfm;
        if (!(a > 0)) continue;  // no force changes anything
        const double w = velocityOf(row, velocities) - row.c + row.cfm * row.force;
        double low = row.low, high = row.high;
        if (row.normalRow != ConstraintRow::kNone) {
            high = std::isinf(high) ? high : std::fabs(high * rows[std::size_t(row.normalRow)].force);
            low = -high;
        }
        const double error = a * (row.force - std::min(std::max(row.force - w / a, low), high));
        if (!std::isfinite(error)) {
            residual.worst = residual.energy = std::numeric_limits<double>::infinity();
            return residual;
        }
        residual.worst = std::max(residual.worst, std::fabs(error));
        residual.energy += error * error * stepSize / (2 * a);
    }
    return residual;
}

}  // namespace quality
