// The relaxation of a row in scalar code. The order of all sums is upstream's.
#pragma once

#include <hwy/base.h>

#include <cmath>

#include "dynamics/step/islands/dxIslandProblem.h"

namespace dxSorKernels {

using Row = dxConstraintRow;

// What the right-hand side and the row's own lambda ask for.
HWY_INLINE dReal residual(const Row &row) { return row.jacobian[Row::kRhs] - row.lambda * row.jacobian[Row::kCfm]; }

// Changes the row's lambda by `delta` as far as its limits allow; returns the change. The branches are kept: if they
// are predicted, the dependency chain does not contain the clamp; branch-free code would add its latency to every row.
HWY_INLINE dReal relax(const dxIslandProblem &problem, Row &row, dReal delta) {
    dReal low = row.jacobian[Row::kLow], high = row.jacobian[Row::kHigh];
    if (row.hasFrictionIndex()) {
        high = std::fabs(high * problem.rows[row.boundingRow].lambda);
        low = -high;
    }
    const dReal old = row.lambda, wanted = old + delta;
    if (wanted < low) {
        row.lambda = low;
        return low - old;
    }
    if (wanted > high) {
        row.lambda = high;
        return high - old;
    }
    row.lambda = wanted;
    return delta;
}

HWY_INLINE dReal dot6(const dReal *a, const dReal *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
}

HWY_INLINE void addScaled6(dReal *a, dReal factor, const dReal *b) {
    for (int i = 0; i < 6; ++i) a[i] += factor * b[i];
}

HWY_INLINE void takeRowPlain(const dxIslandProblem &problem, Row &row) {
    dReal *const on1 = problem.accelerationOf(row.body[0]);
    dReal delta = residual(row) - dot6(on1, row.jacobian + Row::kBody1);
    if (!row.hasSecondBody()) {
        addScaled6(on1, relax(problem, row, delta), row.impulseOn1);
        return;
    }
    dReal *const on2 = problem.accelerationOf(row.body[1]);
    delta -= dot6(on2, row.jacobian + Row::kBody2);
    delta = relax(problem, row, delta);
    addScaled6(on1, delta, row.impulseOn1);
    addScaled6(on2, delta, row.impulseOn2);
}

}  // namespace dxSorKernels
