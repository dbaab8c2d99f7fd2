// What a row does, without vectors. The order of all sums is upstream's.
#pragma once

#include <cmath>
#include <cstddef>

#include "dynamics/sweep/dxSweep.h"

namespace dxSweeping {

inline bool hasSecondBody(const dxSweepIsland &island, std::size_t index) {
    return island.bodiesOfRow[2 * index + 1] != dxSweepIsland::kNone;
}

inline dReal *forceOn(const dxSweepIsland &island, std::size_t index, unsigned which) {
    return island.force + static_cast<std::size_t>(island.bodiesOfRow[2 * index + which]) * dxSweepIsland::kForceColumns;
}

// What the right-hand side and the row's own lambda ask for.
inline dReal residual(const dxSweepIsland &island, std::size_t index) {
    const dReal *row = island.jacobian + index * dxSweepIsland::kJacobianColumns;
    return row[dxSweepIsland::kRhs] - island.lambda[index] * row[dxSweepIsland::kCfm];
}

// Changes the row's lambda by `delta` as far as its limits allow; returns the change. The branches are left to
// the processor's prediction, which goes on with the unlimited change: without them every row would wait.
inline dReal relax(const dxSweepIsland &island, std::size_t index, dReal delta) {
    const dReal *row = island.jacobian + index * dxSweepIsland::kJacobianColumns;
    const int boundingRow = island.boundingRow[index];
    dReal low = row[dxSweepIsland::kLow], high = row[dxSweepIsland::kHigh];
    if (boundingRow != dxSweepIsland::kNone) {
        high = std::fabs(high * island.lambda[boundingRow]);
        low = -high;
    }
    dReal &lambda = island.lambda[index];
    const dReal old = lambda, wanted = old + delta;
    if (wanted < low) {
        lambda = low;
        return low - old;
    }
    if (wanted > high) {
        lambda = high;
        return high - old;
    }
    lambda = wanted;
    return delta;
}

inline dReal dot6(const dReal *a, const dReal *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
}

inline void addScaled6(dReal *a, dReal factor, const dReal *b) {
    for (int i = 0; i < 6; ++i) a[i] += factor * b[i];
}

inline void takeRowPlain(const dxSweepIsland &island, std::size_t index) {
    const dReal *row = island.jacobian + index * dxSweepIsland::kJacobianColumns;
    const dReal *impulse = island.impulse + index * dxSweepIsland::kImpulseColumns;
    const bool two = hasSecondBody(island, index);
    dReal delta = residual(island, index) - dot6(forceOn(island, index, 0), row + dxSweepIsland::kBody1);
    if (two) delta -= dot6(forceOn(island, index, 1), row + dxSweepIsland::kBody2);
    delta = relax(island, index, delta);
    addScaled6(forceOn(island, index, 0), delta, impulse + dxSweepIsland::kOn1);
    if (two) addScaled6(forceOn(island, index, 1), delta, impulse + dxSweepIsland::kOn2);
}

}  // namespace dxSweeping
