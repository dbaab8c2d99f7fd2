#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxBlockFactor.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "core/dxNoIndex.h"
#include "dynamics/world_step/fast/dxBlockFactor.h"
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
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

// Of the column, the blocks from ownBegin to ownEnd get their products; `pivot` those of its diagonal block.
HWY_INLINE void subtractEarlier(const dxFactorArrays &arrays, unsigned column, unsigned ownBegin, unsigned ownEnd, unsigned *slotOf,
                                dxBodyBlock &pivot) {
    const dxEliminationOrder &order = arrays.order;
    const unsigned firstRow = ownBegin < ownEnd ? order.rowOf(ownBegin) : order.bodyCount();
    const unsigned lastRow = ownBegin < ownEnd ? order.rowOf(ownEnd - 1) : 0;
    for (unsigned block = ownBegin; block < ownEnd; ++block) slotOf[order.rowOf(block)] = block;
    for (unsigned e = order.firstEntry(column); e < order.firstEntry(column + 1); ++e) {
        const dxEliminationOrder::RowEntry entry = order.entry(e);
        const dxBodyBlock &factor = arrays.below[entry.block];
        subtractProduct(pivot, factor, factor);
        const unsigned end = order.firstBlock(entry.column + 1);
        unsigned source = entry.block + 1;
        while (source < end && order.rowOf(source) < firstRow) ++source;
        for (; source < end && order.rowOf(source) <= lastRow; ++source)
            subtractProduct(arrays.below[slotOf[order.rowOf(source)]], arrays.below[source], factor);
    }
}

// Columns whose products all come from one another.
bool factoriseColumns(const dxFactorArrays &arrays, unsigned beginColumn, unsigned endColumn, unsigned *slotOf) {
    for (unsigned column = beginColumn; column < endColumn; ++column) {
        const unsigned begin = arrays.order.firstBlock(column), end = arrays.order.firstBlock(column + 1);
        subtractEarlier(arrays, column, begin, end, slotOf, arrays.diagonal[column]);
        if (!factorPivot(arrays.diagonal[column], arrays.inverses[column])) return false;
        for (unsigned block = begin; block < end; ++block) multiplyTransposed(arrays.below[block], arrays.inverses[column].byColumns);
    }
    return true;
}

// One of `parts` of a column's blocks. The diagonal block is read by all of them and stays as it is.
bool factorisePart(const dxFactorArrays &arrays, unsigned column, unsigned part, unsigned parts, unsigned *slotOf) {
    const unsigned begin = arrays.order.firstBlock(column), count = arrays.order.firstBlock(column + 1) - begin;
    const unsigned ownBegin = begin + count * part / parts, ownEnd = begin + count * (part + 1) / parts;
    dxBodyBlock pivot = arrays.diagonal[column];
    subtractEarlier(arrays, column, ownBegin, ownEnd, slotOf, pivot);
    dxPivotInverse inverse = {};
    if (!factorPivot(pivot, inverse)) return false;
    for (unsigned block = ownBegin; block < ownEnd; ++block) multiplyTransposed(arrays.below[block], inverse.byColumns);
    if (part == 0) arrays.inverses[column] = inverse;
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

// inv(L) y, for a range of columns. Rows outside may have spills for targets.
void solveForward(const dxFactorArrays &arrays, unsigned beginColumn, unsigned endColumn, dxBodyVectors &y, dxBodyVector *spills) {
    const dxEliminationOrder &order = arrays.order;
    const unsigned *const targets = arrays.targets, bodies = order.bodyCount();
    for (unsigned column = beginColumn; column < endColumn; ++column) {
        multiply(arrays.inverses[column].byColumns, y[column]);
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block) {
            const unsigned target = targets[block];
            subtractTimes(target < bodies ? y[target] : spills[target - bodies], arrays.below[block], y[column]);
        }
    }
}

// inv(L') y, for a range of columns. Requires those of all rows in them.
void solveBackward(const dxFactorArrays &arrays, unsigned beginColumn, unsigned endColumn, dxBodyVectors &y) {
    for (unsigned column = endColumn; column-- > beginColumn;) {
        subtractTransposed(arrays.order, arrays.below, column, y);
        multiply(arrays.inverses[column].byRows, y[column]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxFastStepKernels {
HWY_EXPORT(factoriseColumns);
HWY_EXPORT(factorisePart);
HWY_EXPORT(solveForward);
HWY_EXPORT(solveBackward);
}  // namespace dxFastStepKernels

namespace {

// Products of blocks, at some 10 ns: less is not shared.
constexpr double kMinShared = 2000;

// A subtree of more than this part of all products is cut.
constexpr double kMaxPart = 1.0 / 24;

// A column's other work, in products of blocks: its own blocks and its pivot.
double workOf(double blocks) { return blocks * (blocks + 1) / 2 + blocks + 8; }

// Products of blocks in a column at the top, at some 10 ns, and blocks of each part, from which on it is shared.
constexpr unsigned kMinSharedWork = 200, kMinPart = 6;

void add(dxBodyVector &sum, const dxBodyVector &other) {
    for (unsigned lane = 0; lane < kBodyLanes; ++lane) sum.lane[lane] += other.lane[lane];
}

}  // namespace

void dxFactorPlan::make(const dxEliminationOrder &order) {
    weighSubtrees(order);
    cutTree(order);
    weighTop(order);
    listTargets(order);
}

// Children come before their parents.
void dxFactorPlan::weighSubtrees(const dxEliminationOrder &order) {
    m_total = 0;
    m_weights.assign(order.bodyCount(), 0);
    for (unsigned column = 0; column < order.bodyCount(); ++column) {
        const double work = workOf(order.firstBlock(column + 1) - order.firstBlock(column));
        m_total += work;
        m_weights[column] += work;
        const unsigned parent = order.parentOf(column);
        if (parent != kNoIndex) m_weights[parent] += m_weights[column];
    }
}

// A chunk ends with a subtree, before a column of the top, or when it is large enough.
void dxFactorPlan::cutTree(const dxEliminationOrder &order) {
    const double most = m_total < kMinShared ? 2 * m_total : kMaxPart * m_total;
    m_chunks.clear();
    m_top.clear();
    m_isTop.assign(order.bodyCount(), 0);
    for (unsigned column = 0; column < order.bodyCount(); ++column) m_isTop[column] = m_weights[column] > most;
    double weight = 0;
    bool isOpen = false;
    for (unsigned column = 0; column < order.bodyCount(); ++column) {
        if (m_isTop[column]) {
            m_top.push_back(column);
            isOpen = false;
            continue;
        }
        if (!isOpen) {
            m_chunks.push_back({column, column, 0, 0});
            weight = 0;
            isOpen = true;
        }
        m_chunks.back().end = column + 1;
        const unsigned parent = order.parentOf(column);
        if (parent != kNoIndex && !m_isTop[parent]) continue;
        weight += m_weights[column];
        isOpen = weight <= most / 2;
    }
}

void dxFactorPlan::weighTop(const dxEliminationOrder &order) {
    m_topWork.clear();
    for (const unsigned column : m_top) {
        unsigned work = order.firstBlock(column + 1) - order.firstBlock(column);
        for (unsigned e = order.firstEntry(column); e < order.firstEntry(column + 1); ++e)
            work += order.firstBlock(order.entry(e).column + 1) - order.entry(e).block;
        m_topWork.push_back(work);
    }
}

void dxFactorPlan::listTargets(const dxEliminationOrder &order) {
    const unsigned bodies = order.bodyCount();
    m_targets.resize(order.blockCount());
    for (const unsigned column : m_top)
        for (unsigned block = order.firstBlock(column); block < order.firstBlock(column + 1); ++block)
            m_targets[block] = order.rowOf(block);
    m_spillRows.clear();
    m_spillOf.assign(bodies, kNoIndex);
    for (Chunk &chunk : m_chunks) {
        chunk.firstSpill = static_cast<unsigned>(m_spillRows.size());
        for (unsigned block = order.firstBlock(chunk.begin); block < order.firstBlock(chunk.end); ++block) {
            const unsigned row = order.rowOf(block);
            m_targets[block] = row;
            if (!m_isTop[row]) continue;
            if (m_spillOf[row] == kNoIndex || m_spillOf[row] < chunk.firstSpill) {
                m_spillOf[row] = static_cast<unsigned>(m_spillRows.size());
                m_spillRows.push_back(row);
            }
            m_targets[block] = bodies + m_spillOf[row];
        }
        chunk.endSpill = static_cast<unsigned>(m_spillRows.size());
    }
}

void dxBlockFactor::shape(const dxEliminationOrder &order, unsigned threads) {
    m_order = &order;
    m_plan.make(order);
    m_diagonal.resize(order.bodyCount());
    m_below.resize(order.blockCount());
    m_inverses.assign(order.bodyCount(), dxPivotInverse{});
    if (m_slotOf.size() < threads) m_slotOf.resize(threads);
    for (unsigned share = 0; share < threads; ++share) m_slotOf[share].resize(order.bodyCount());
    m_spills.resize(m_plan.spillRows().size());
}

dxFactorArrays dxBlockFactor::arrays() {
    return {*m_order, m_diagonal.data(), m_below.data(), m_inverses.data(), m_plan.targets().data()};
}

void dxBlockFactor::factoriseColumns(unsigned begin, unsigned end, unsigned share) {
    if (!HWY_DYNAMIC_DISPATCH(dxFastStepKernels::factoriseColumns)(arrays(), begin, end, m_slotOf[share].data()))
        m_isRegular.store(false, std::memory_order_relaxed);
}

void dxBlockFactor::factoriseTop(dxPhaseRunner &phases) {
    for (std::size_t i = 0; i < m_plan.top().size() && m_isRegular.load(std::memory_order_relaxed); ++i) {
        const unsigned column = m_plan.top()[i], blocks = m_order->firstBlock(column + 1) - m_order->firstBlock(column);
        const unsigned parts = m_plan.topWork()[i] < kMinSharedWork ? 1 : std::clamp(blocks / kMinPart, 1u, phases.threads());
        phases.forChunks(parts, [&](unsigned part, unsigned share) {
            if (!HWY_DYNAMIC_DISPATCH(dxFastStepKernels::factorisePart)(arrays(), column, part, parts, m_slotOf[share].data()))
                m_isRegular.store(false, std::memory_order_relaxed);
        });
    }
}

void dxBlockFactor::solve(dxPhaseRunner &phases, dxBodyVectors &y) {
    const std::vector<dxFactorPlan::Chunk> &chunks = m_plan.chunks();
    const std::vector<unsigned> &top = m_plan.top();
    const dxFactorArrays arrays = this->arrays();
    phases.forChunks(static_cast<unsigned>(chunks.size()), [&](unsigned chunk, unsigned) {
        std::fill(m_spills.begin() + chunks[chunk].firstSpill, m_spills.begin() + chunks[chunk].endSpill, dxBodyVector{});
        HWY_DYNAMIC_DISPATCH(dxFastStepKernels::solveForward)(arrays, chunks[chunk].begin, chunks[chunk].end, y, m_spills.data());
    });
    for (std::size_t i = 0; i < m_spills.size(); ++i) add(y[m_plan.spillRows()[i]], m_spills[i]);
    for (const unsigned column : top) HWY_DYNAMIC_DISPATCH(dxFastStepKernels::solveForward)(arrays, column, column + 1, y, m_spills.data());
    for (std::size_t i = top.size(); i-- > 0;) HWY_DYNAMIC_DISPATCH(dxFastStepKernels::solveBackward)(arrays, top[i], top[i] + 1, y);
    phases.forChunks(static_cast<unsigned>(chunks.size()), [&](unsigned chunk, unsigned) {
        HWY_DYNAMIC_DISPATCH(dxFastStepKernels::solveBackward)(arrays, chunks[chunk].begin, chunks[chunk].end, y);
    });
}
#endif
