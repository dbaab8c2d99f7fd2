#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/direct/dxBlockFactor.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/direct/dxBlockFactor.h"
#include "dynamics/direct/dxBodyLanes-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

// target -= left * right', as kernels of one vector of rows each.
HWY_INLINE void subtractProduct(dxBodyBlock &target, const dxBodyBlock &left, const dxBodyBlock &right) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyLanes && lane < kBodyAxes; lane += hn::Lanes(d)) {
        const auto l0 = hn::Load(d, left.column[0].lane + lane), l1 = hn::Load(d, left.column[1].lane + lane),
                   l2 = hn::Load(d, left.column[2].lane + lane), l3 = hn::Load(d, left.column[3].lane + lane),
                   l4 = hn::Load(d, left.column[4].lane + lane), l5 = hn::Load(d, left.column[5].lane + lane);
        HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c) {
            auto sum = hn::Load(d, target.column[c].lane + lane);
            sum = hn::Sub(sum, hn::Mul(l0, hn::Set(d, right.column[0].lane[c])));
            sum = hn::Sub(sum, hn::Mul(l1, hn::Set(d, right.column[1].lane[c])));
            sum = hn::Sub(sum, hn::Mul(l2, hn::Set(d, right.column[2].lane[c])));
            sum = hn::Sub(sum, hn::Mul(l3, hn::Set(d, right.column[3].lane[c])));
            sum = hn::Sub(sum, hn::Mul(l4, hn::Set(d, right.column[4].lane[c])));
            sum = hn::Sub(sum, hn::Mul(l5, hn::Set(d, right.column[5].lane[c])));
            hn::Store(sum, d, target.column[c].lane + lane);
        }
    }
}

// target * inverse', where `inverse` is inv(pivot), lower triangular.
HWY_INLINE void multiplyTransposed(dxBodyBlock &target, const dxBodyBlock &inverse) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d)) {
        hn::Vec<BodyTag> column[kBodyAxes];
        for (unsigned c = 0; c < kBodyAxes; ++c) column[c] = hn::Load(d, target.column[c].lane + lane);
        HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c) {
            auto sum = hn::Mul(column[0], hn::Set(d, inverse.column[0].lane[c]));
            for (unsigned k = 1; k <= c; ++k) sum = hn::Add(sum, hn::Mul(column[k], hn::Set(d, inverse.column[k].lane[c])));
            hn::Store(sum, d, target.column[c].lane + lane);
        }
    }
}

// Cholesky of one block, and the inverse of its factor: by columns, and by rows, for both directions of a solve.
HWY_INLINE bool factorPivot(dxBodyBlock &block, dxPivotInverse &inverse) {
    double factor[kBodyAxes][kBodyAxes];
    for (unsigned c = 0; c < kBodyAxes; ++c)
        for (unsigned r = c; r < kBodyAxes; ++r) {
            double sum = block.column[c].lane[r];
            for (unsigned k = 0; k < c; ++k) sum -= factor[r][k] * factor[c][k];
            if (r > c) {
                factor[r][c] = sum * inverse.byColumns.column[c].lane[c];
                continue;
            }
            if (!(sum > 0) || !std::isfinite(sum)) return false;
            inverse.byColumns.column[c].lane[c] = inverse.byRows.column[c].lane[c] = 1 / std::sqrt(sum);
        }
    for (unsigned c = 0; c < kBodyAxes; ++c)
        for (unsigned r = c + 1; r < kBodyAxes; ++r) {
            double sum = 0;
            for (unsigned k = c; k < r; ++k) sum += factor[r][k] * inverse.byColumns.column[c].lane[k];
            inverse.byColumns.column[c].lane[r] = inverse.byRows.column[r].lane[c] = -sum * inverse.byColumns.column[r].lane[r];
        }
    return true;
}

bool factorise(const dxEliminationOrder &order, dxBodyBlocks &diagonal, dxBodyBlocks &below, std::vector<dxPivotInverse> &inverses,
               unsigned *slotOf) {
    const unsigned bodies = order.bodyCount();
    dxBodyBlock *const blocks = below.data();
    for (unsigned column = 0; column < bodies; ++column) {
        const unsigned begin = order.firstBlock(column), end = order.firstBlock(column + 1);
        for (unsigned block = begin; block < end; ++block) slotOf[order.rowOf(block)] = block;
        for (unsigned e = order.firstEntry(column); e < order.firstEntry(column + 1); ++e) {
            const dxEliminationOrder::RowEntry entry = order.entry(e);
            const dxBodyBlock &factor = blocks[entry.block];
            subtractProduct(diagonal[column], factor, factor);
            const unsigned sourceEnd = order.firstBlock(entry.column + 1);
            for (unsigned source = entry.block + 1; source < sourceEnd; ++source)
                subtractProduct(blocks[slotOf[order.rowOf(source)]], blocks[source], factor);
        }
        if (!factorPivot(diagonal[column], inverses[column])) return false;
        for (unsigned block = begin; block < end; ++block) multiplyTransposed(blocks[block], inverses[column].byColumns);
    }
    return true;
}

// y = block * y
HWY_INLINE void multiply(const dxBodyBlock &block, dxBodyVector &y) {
    const BodyTag d;
    const dxBodyVector old = y;
    for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d)) {
        const auto product = [&](unsigned c) {
            return hn::Mul(hn::Load(d, block.column[c].lane + lane), hn::Set(d, old.lane[c]));
        };
        const auto even = hn::Add(hn::Add(product(0), product(2)), product(4));
        const auto odd = hn::Add(hn::Add(product(1), product(3)), product(5));
        hn::Store(hn::Add(even, odd), d, y.lane + lane);
    }
}

// target -= block * y
HWY_INLINE void subtractTimes(dxBodyVector &target, const dxBodyBlock &block, const dxBodyVector &y) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d)) {
        const auto product = [&](unsigned c) {
            return hn::Mul(hn::Load(d, block.column[c].lane + lane), hn::Set(d, y.lane[c]));
        };
        const auto even = hn::Add(hn::Add(product(0), product(2)), product(4));
        const auto odd = hn::Add(hn::Add(product(1), product(3)), product(5));
        hn::Store(hn::Sub(hn::Load(d, target.lane + lane), hn::Add(even, odd)), d, target.lane + lane);
    }
}

// y(column) -= the sum over blocks of block' * y(row)
HWY_INLINE void subtractTransposed(const dxEliminationOrder &order, const dxBodyBlock *below, unsigned column, dxBodyVectors &y) {
    const BodyTag d;
    const unsigned begin = order.firstBlock(column), end = order.firstBlock(column + 1);
    if (begin == end) return;
    dxBodyBlock sums;
    for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
        hn::Vec<BodyTag> sum[kBodyAxes];
        for (unsigned c = 0; c < kBodyAxes; ++c) sum[c] = hn::Zero(d);
        for (unsigned block = begin; block < end; ++block) {
            const auto other = hn::Load(d, y[order.rowOf(block)].lane + lane);
            HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c)
                sum[c] = hn::Add(sum[c], hn::Mul(hn::Load(d, below[block].column[c].lane + lane), other));
        }
        for (unsigned c = 0; c < kBodyAxes; ++c) hn::Store(sum[c], d, sums.column[c].lane + lane);
    }
    for (unsigned c = 0; c < kBodyAxes; ++c) y[column].lane[c] -= addUp(sums.column[c].lane);
}

void solve(const dxEliminationOrder &order, const dxBodyBlocks &below, const std::vector<dxPivotInverse> &inverses,
           dxBodyVectors &y) {
    const unsigned bodies = order.bodyCount();
    for (unsigned column = 0; column < bodies; ++column) {
        multiply(inverses[column].byColumns, y[column]);
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block)
            subtractTimes(y[order.rowOf(block)], below[block], y[column]);
    }
    for (unsigned column = bodies; column-- > 0;) {
        subtractTransposed(order, below.data(), column, y);
        multiply(inverses[column].byRows, y[column]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxDirect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxDirect {
HWY_EXPORT(factorise);
HWY_EXPORT(solve);
}  // namespace dxDirect

void dxBlockFactor::shape(const dxEliminationOrder &order) {
    m_order = &order;
    m_diagonal.resize(order.bodyCount());
    m_below.resize(order.blockCount());
    m_inverses.assign(order.bodyCount(), dxPivotInverse{});
    m_slotOf.resize(order.bodyCount());
}

bool dxBlockFactor::factorise() {
    return HWY_DYNAMIC_DISPATCH(dxDirect::factorise)(*m_order, m_diagonal, m_below, m_inverses, m_slotOf.data());
}

void dxBlockFactor::solve(dxBodyVectors &y) const {
    HWY_DYNAMIC_DISPATCH(dxDirect::solve)(*m_order, m_below, m_inverses, y);
}
#endif
