// What a row does, without vectors. The order of all sums is upstream's.
#pragma once

#include <hwy/base.h>

#include <cmath>
#include <cstddef>

#include "dynamics/sweep/dxSweep.h"

namespace dxSweeping {

// A row of upstream's arrays.
class ArrayRow {
public:
    ArrayRow(const dxSweepIsland &island, std::size_t index) : m_island(island), m_index(index) {}

    const dReal *jacobian() const { return m_island.jacobian + m_index * dxSweepIsland::kJacobianColumns; }
    const dReal *impulse() const { return m_island.impulse + m_index * dxSweepIsland::kImpulseColumns; }
    int body(unsigned which) const { return m_island.bodiesOfRow[2 * m_index + which]; }
    int boundingRow() const { return m_island.boundingRow[m_index]; }
    dReal &lambda() const { return m_island.lambda[m_index]; }
    dReal lambdaOf(int row) const { return m_island.lambda[row]; }

private:
    const dxSweepIsland &m_island;
    std::size_t m_index;
};

// A packed row.
class PackedRow {
public:
    PackedRow(const dxSweepIsland &island, std::size_t index) : m_island(island), m_index(index) {}

    const dReal *jacobian() const { return m_island.jacobian + m_index * dxSweepIsland::kJacobianColumns; }
    const dReal *impulse() const { return row().impulse; }
    int body(unsigned which) const { return row().body[which]; }
    int boundingRow() const { return row().boundingRow; }
    dReal &lambda() const { return row().lambda; }
    dReal lambdaOf(int other) const { return m_island.packed[other].lambda; }
    // Its own, if no row bounds it; found without a branch.
    const dReal &boundingLambda() const {
        const std::size_t noneMask = std::size_t(0) - static_cast<std::size_t>(boundingRow() < 0);  // all bits, or no bit
        return m_island.packed[(m_index & noneMask) | (static_cast<std::size_t>(boundingRow()) & ~noneMask)].lambda;
    }

private:
    dxSweepRow &row() const { return m_island.packed[m_index]; }

    const dxSweepIsland &m_island;
    std::size_t m_index;
};

template <class Row>
HWY_INLINE bool hasSecondBody(const Row &row) {
    return row.body(1) != dxSweepIsland::kNone;
}

template <class Row>
HWY_INLINE dReal *forceOn(const dxSweepIsland &island, const Row &row, unsigned which) {
    return island.force + static_cast<std::size_t>(row.body(which)) * dxSweepIsland::kForceColumns;
}

// What the right-hand side and the row's own lambda ask for.
template <class Row>
HWY_INLINE dReal residual(const Row &row) {
    return row.jacobian()[dxSweepIsland::kRhs] - row.lambda() * row.jacobian()[dxSweepIsland::kCfm];
}

// Changes the row's lambda by `delta` as far as its limits allow; returns the change. The branches are left to
// the processor's prediction, which goes on with the unlimited change: without them every row would wait.
template <class Row>
HWY_INLINE dReal relax(const Row &row, dReal delta) {
    dReal low = row.jacobian()[dxSweepIsland::kLow], high = row.jacobian()[dxSweepIsland::kHigh];
    const int boundingRow = row.boundingRow();
    if (boundingRow != dxSweepIsland::kNone) {
        high = std::fabs(high * row.lambdaOf(boundingRow));
        low = -high;
    }
    dReal &lambda = row.lambda();
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

HWY_INLINE dReal dot6(const dReal *a, const dReal *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
}

HWY_INLINE void addScaled6(dReal *a, dReal factor, const dReal *b) {
    for (int i = 0; i < 6; ++i) a[i] += factor * b[i];
}

template <class Row>
HWY_INLINE void takeRowPlain(const dxSweepIsland &island, const Row &row) {
    const bool two = hasSecondBody(row);
    dReal delta = residual(row) - dot6(forceOn(island, row, 0), row.jacobian() + dxSweepIsland::kBody1);
    if (two) delta -= dot6(forceOn(island, row, 1), row.jacobian() + dxSweepIsland::kBody2);
    delta = relax(row, delta);
    addScaled6(forceOn(island, row, 0), delta, row.impulse() + dxSweepIsland::kOn1);
    if (two) addScaled6(forceOn(island, row, 1), delta, row.impulse() + dxSweepIsland::kOn2);
}

}  // namespace dxSweeping
