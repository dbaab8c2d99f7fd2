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

// target * inv(pivot)', where pivot is lower triangular.
HWY_INLINE void divide(dxBodyBlock &target, const dxBodyBlock &pivot, const dxBodyVector &inversePivot) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyLanes && lane < kBodyAxes; lane += hn::Lanes(d)) {
        hn::Vec<BodyTag> done[kBodyAxes];
        HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c) {
            auto sum = hn::Load(d, target.column[c].lane + lane);
            for (unsigned k = 0; k < c; ++k) sum = hn::Sub(sum, hn::Mul(done[k], hn::Set(d, pivot.column[k].lane[c])));
            done[c] = hn::Mul(sum, hn::Set(d, inversePivot.lane[c]));
            hn::Store(done[c], d, target.column[c].lane + lane);
        }
    }
}

// Cholesky of one block. What is above the diagonal is of no use afterwards.
HWY_INLINE bool factorPivot(dxBodyBlock &block, dxBodyVector &inversePivot) {
    const BodyTag d;
    for (unsigned c = 0; c < kBodyAxes; ++c) {
        double *const column = block.column[c].lane;
        const double pivot = column[c];
        if (!(pivot > 0) || !std::isfinite(pivot)) return false;
        const double inverse = 1 / std::sqrt(pivot);
        inversePivot.lane[c] = inverse;
        for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d))
            hn::Store(hn::Mul(hn::Load(d, column + lane), hn::Set(d, inverse)), d, column + lane);
        for (unsigned k = c + 1; k < kBodyAxes; ++k) {
            double *const later = block.column[k].lane;
            const auto factor = hn::Set(d, column[k]);
            for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d))
                hn::Store(hn::Sub(hn::Load(d, later + lane), hn::Mul(hn::Load(d, column + lane), factor)), d, later + lane);
        }
    }
    return true;
}

bool factorise(const dxEliminationOrder &order, dxBodyBlocks &diagonal, dxBodyBlocks &below, dxBodyVectors &inversePivots,
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
        if (!factorPivot(diagonal[column], inversePivots[column])) return false;
        for (unsigned block = begin; block < end; ++block) divide(blocks[block], diagonal[column], inversePivots[column]);
    }
    return true;
}

HWY_INLINE void solvePivot(const dxBodyBlock &pivot, const dxBodyVector &inversePivot, double *y) {
    for (unsigned c = 0; c < kBodyAxes; ++c) {
        y[c] *= inversePivot.lane[c];
        for (unsigned r = c + 1; r < kBodyAxes; ++r) y[r] -= pivot.column[c].lane[r] * y[c];
    }
}

HWY_INLINE void solvePivotTransposed(const dxBodyBlock &pivot, const dxBodyVector &inversePivot, double *y) {
    for (unsigned c = kBodyAxes; c-- > 0;) {
        double sum = y[c];
        for (unsigned r = c + 1; r < kBodyAxes; ++r) sum -= pivot.column[c].lane[r] * y[r];
        y[c] = sum * inversePivot.lane[c];
    }
}

// y(row) -= block * y(column)
HWY_INLINE void subtractTimes(dxBodyVector &target, const dxBodyBlock &block, const double *y) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyAxes; lane += hn::Lanes(d)) {
        auto sum = hn::Load(d, target.lane + lane);
        HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c)
            sum = hn::Sub(sum, hn::Mul(hn::Load(d, block.column[c].lane + lane), hn::Set(d, y[c])));
        hn::Store(sum, d, target.lane + lane);
    }
}

void solve(const dxEliminationOrder &order, const dxBodyBlocks &diagonal, const dxBodyBlocks &below,
           const dxBodyVectors &inversePivots, dxBodyVectors &y) {
    const unsigned bodies = order.bodyCount();
    for (unsigned column = 0; column < bodies; ++column) {
        solvePivot(diagonal[column], inversePivots[column], y[column].lane);
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block)
            subtractTimes(y[order.rowOf(block)], below[block], y[column].lane);
    }
    for (unsigned column = bodies; column-- > 0;) {
        double *const own = y[column].lane;
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block) {
            const dxBodyVector &other = y[order.rowOf(block)];
            HWY_UNROLL(6) for (unsigned c = 0; c < kBodyAxes; ++c) own[c] -= addUpProducts(below[block].column[c], other);
        }
        solvePivotTransposed(diagonal[column], inversePivots[column], own);
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
    m_inversePivots.resize(order.bodyCount());
    m_slotOf.resize(order.bodyCount());
}

bool dxBlockFactor::factorise() {
    return HWY_DYNAMIC_DISPATCH(dxDirect::factorise)(*m_order, m_diagonal, m_below, m_inversePivots, m_slotOf.data());
}

void dxBlockFactor::solve(dxBodyVectors &y) const {
    HWY_DYNAMIC_DISPATCH(dxDirect::solve)(*m_order, m_diagonal, m_below, m_inversePivots, y);
}
#endif
