#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxFrontFactor.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxFrontFactor.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
namespace HWY_NAMESPACE {

constexpr unsigned kTile = 4;  // columns

// Calls work(count), a number of at most kTile being a constant in it.
template <class Work>
HWY_INLINE void withColumns(unsigned count, const Work &work) {
    switch (count) {
        case 1: return work(std::integral_constant<unsigned, 1>());
        case 2: return work(std::integral_constant<unsigned, 2>());
        case 3: return work(std::integral_constant<unsigned, 3>());
        default: return work(std::integral_constant<unsigned, kTile>());
    }
}

// Columns of a tile less the products of a group's columns: target(row, c) -= sum over k of source(row, k) * multipliers(c, k). Columns of the
// source and of the multipliers are `stride` apart. `kIsFirst`: the target's numbers are taken as 0.
struct Tile {
    double *target;
    const double *source, *multipliers;
    unsigned targetStride, stride, group;
};

template <unsigned kColumns, unsigned kVectors, bool kIsFirst>
HWY_INLINE void subtractAt(const Tile &tile, unsigned row) {
    const BodyTag d;
    const unsigned n = static_cast<unsigned>(hn::Lanes(d));
    double *const HWY_RESTRICT target = tile.target + row;
    const double *HWY_RESTRICT source = tile.source + row, *HWY_RESTRICT multipliers = tile.multipliers;
    hn::Vec<BodyTag> sums[kColumns][kVectors];
    HWY_UNROLL(4) for (unsigned c = 0; c < kColumns; ++c)
        HWY_UNROLL(2) for (unsigned v = 0; v < kVectors; ++v)
            sums[c][v] = kIsFirst ? hn::Zero(d) : hn::Load(d, target + c * tile.targetStride + v * n);
    for (unsigned k = 0; k < tile.group; ++k) {
        hn::Vec<BodyTag> factor[kVectors];
        HWY_UNROLL(2) for (unsigned v = 0; v < kVectors; ++v) factor[v] = hn::Load(d, source + v * n);
        HWY_UNROLL(4) for (unsigned c = 0; c < kColumns; ++c) {
            const auto multiplier = hn::Set(d, multipliers[c]);
            HWY_UNROLL(2) for (unsigned v = 0; v < kVectors; ++v) sums[c][v] = hn::Sub(sums[c][v], hn::Mul(factor[v], multiplier));
        }
        source += tile.stride;
        multipliers += tile.stride;
    }
    HWY_UNROLL(4) for (unsigned c = 0; c < kColumns; ++c)
        HWY_UNROLL(2) for (unsigned v = 0; v < kVectors; ++v) hn::Store(sums[c][v], d, target + c * tile.targetStride + v * n);
}

// The same for rows from `begin` to the end of the columns.
template <bool kIsFirst>
HWY_INLINE void subtractFrom(const Tile &tile, unsigned count, unsigned begin) {
    withColumns(count, [&](auto columns) HWY_ATTR {
        constexpr unsigned kColumns = decltype(columns)::value;
        const unsigned n = static_cast<unsigned>(hn::Lanes(BodyTag()));
        unsigned row = begin / dxFrontPlan::kLine * dxFrontPlan::kLine;
        for (; row + 2 * n <= tile.targetStride; row += 2 * n) subtractAt<kColumns, 2, kIsFirst>(tile, row);
        for (; row < tile.targetStride; row += n) subtractAt<kColumns, 1, kIsFirst>(tile, row);
    });
}

// A few columns of a group among themselves: their pivots, then the rows below them.
template <unsigned kColumns>
HWY_INLINE bool factoriseTile(const dxFrontNumbers &front, unsigned first, double *multipliers) {
    const BodyTag d;
    double *const columns = front.column(first);
    const unsigned stride = front.stride;
    double rows[kColumns][kColumns], factor[kColumns][kColumns];
    for (unsigned r = 0; r < kColumns; ++r)
        for (unsigned s = r; s < kColumns; ++s) rows[r][s] = columns[r * stride + first + s];
    bool isRegular = true;
    for (unsigned r = 0; r < kColumns; ++r) {
        const double pivot = rows[r][r], inverse = 1 / pivot;
        isRegular &= pivot > kMinPivot * front.diagonals[first + r] && pivot < std::numeric_limits<double>::infinity();
        front.inverses[first + r] = inverse;
        for (unsigned s = r + 1; s < kColumns; ++s) {
            factor[s][r] = rows[r][s] * inverse;
            for (unsigned k = s; k < kColumns; ++k) rows[s][k] -= factor[s][r] * rows[r][k];
        }
    }
    for (unsigned row = first / dxFrontPlan::kLine * dxFrontPlan::kLine; row < stride; row += static_cast<unsigned>(hn::Lanes(d))) {
        hn::Vec<BodyTag> known[kColumns];
        HWY_UNROLL(4) for (unsigned s = 0; s < kColumns; ++s) {
            known[s] = hn::Load(d, columns + s * stride + row);
            HWY_UNROLL(4) for (unsigned r = 0; r < s; ++r) known[s] = hn::Sub(known[s], hn::Mul(known[r], hn::Set(d, factor[s][r])));
            if (s > 0) hn::Store(known[s], d, columns + s * stride + row);
            hn::Store(hn::Mul(known[s], hn::Set(d, front.inverses[first + s])), d, multipliers + s * stride + row);
        }
    }
    return isRegular;
}

// The columns of a group, among themselves.
bool factoriseGroup(const dxFrontNumbers &front, unsigned begin, unsigned end) {
    for (unsigned first = begin, known; first < end; first = known) {
        known = HWY_MIN(first + kTile, end);
        double *const multipliers = front.multipliersOf(first - begin);
        bool isRegular = true;
        withColumns(known - first, [&](auto columns) HWY_ATTR {
            isRegular = factoriseTile<decltype(columns)::value>(front, first, multipliers);
        });
        if (!isRegular) return false;
        for (unsigned next = known; next < end; next += kTile) {
            const Tile tile{front.column(next), front.column(first), multipliers + next, front.stride, front.stride, known - first};
            subtractFrom<false>(tile, HWY_MIN(end - next, kTile), next);
        }
    }
    return true;
}

template <bool kIsFirst>
HWY_INLINE void subtractFromUpdate(const dxFrontNumbers &front, unsigned begin, unsigned end, unsigned first, unsigned last) {
    const unsigned line = front.firstUpdateLine();
    for (unsigned next = HWY_MAX(first, front.pivots); next < last; next += kTile) {
        const Tile tile{front.updateColumn(next - front.pivots), front.column(begin) + line, front.multipliersOf(0) + next,
                        front.updateStride, front.stride, end - begin};
        subtractFrom<kIsFirst>(tile, HWY_MIN(last - next, kTile), next - line);
    }
}

// Of columns behind a group, from `first` to `last`, what the group's columns make of them. The first group makes those of the update.
void subtractGroup(const dxFrontNumbers &front, unsigned begin, unsigned end, unsigned first, unsigned last) {
    const unsigned lastPivot = HWY_MIN(last, front.pivots);
    for (unsigned next = first; next < lastPivot; next += kTile) {
        const Tile tile{front.column(next), front.column(begin), front.multipliersOf(0) + next, front.stride, front.stride, end - begin};
        subtractFrom<false>(tile, HWY_MIN(lastPivot - next, kTile), next);
    }
    if (begin == 0)
        subtractFromUpdate<true>(front, begin, end, first, last);
    else
        subtractFromUpdate<false>(front, begin, end, first, last);
}

HWY_INLINE void addRun(const double *source, unsigned length, double *target) {
    const BodyTag d;
    const unsigned n = static_cast<unsigned>(hn::Lanes(d));
    unsigned i = 0;
    for (; i + n <= length; i += n) hn::StoreU(hn::Add(hn::LoadU(d, target + i), hn::LoadU(d, source + i)), d, target + i);
    for (; i < length; ++i) target[i] += source[i];
}

// Adds the columns of a child's update that are the front's pivots, or the others. Columns of `update` begin with row 0.
void addUpdate(const dxFrontNumbers &front, bool toPivots, const dxFrontPlan::Run *runs, const dxFrontPlan::Run *end, const double *update,
               unsigned stride) {
    for (const dxFrontPlan::Run *run = runs; run + 1 < end; ++run) {
        if ((run->to < front.pivots) != toPivots) continue;
        for (unsigned c = 0; c < run->length; ++c) {
            const double *const source = update + std::size_t(run->from + c) * stride;
            const unsigned column = run->to + c;
            double *const target = toPivots ? front.column(column) : front.updateColumn(column - front.pivots) - front.firstUpdateLine();
            addRun(source + run->from + c, run->length - c, target + column);
            for (const dxFrontPlan::Run *other = run + 1; other < end; ++other)
                addRun(source + other->from, other->length, target + other->to);
        }
    }
}

// From the x of rows below, which are behind those of the pivots, the latter.
void substituteFront(const dxFrontNumbers &front, double *x) {
    const BodyTag d;
    const unsigned rightSide = front.columns();
    alignas(kCacheLine) double sums[kTile][kBodyLanes];
    for (unsigned end = front.pivots, begin; end > 0; end = begin) {
        begin = (end - 1) / kTile * kTile;
        for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d))
            withColumns(end - begin, [&](auto columns) HWY_ATTR {
                constexpr unsigned kColumns = decltype(columns)::value;
                hn::Vec<BodyTag> sum[kColumns];
                for (unsigned c = 0; c < kColumns; ++c) sum[c] = hn::Zero(d);
                for (unsigned row = end / kBodyLanes * kBodyLanes + lane; row < rightSide; row += kBodyLanes) {
                    const auto known = hn::Load(d, x + row);
                    for (unsigned c = 0; c < kColumns; ++c)
                        sum[c] = hn::Add(sum[c], hn::Mul(hn::Load(d, front.column(begin + c) + row), known));
                }
                for (unsigned c = 0; c < kColumns; ++c) hn::Store(sum[c], d, sums[c] + lane);
            });
        for (unsigned k = end; k-- > begin;) {
            const double *const column = front.column(k);
            double sum = column[rightSide] - addUp(sums[k - begin]);
            for (unsigned row = k + 1; row < end; ++row) sum -= column[row] * x[row];
            x[k] = sum * front.inverses[k];
        }
    }
}

// All of a front that one thread has.
bool eliminateFront(const dxFrontNumbers &front) {
    for (unsigned begin = 0; begin < front.pivots;) {
        const unsigned end = front.endOfGroup(begin);
        if (!factoriseGroup(front, begin, end)) return false;
        subtractGroup(front, begin, end, end, front.columns());
        begin = end;
    }
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxFastStepKernels {
HWY_EXPORT(factoriseGroup);
HWY_EXPORT(subtractGroup);
HWY_EXPORT(eliminateFront);
HWY_EXPORT(addUpdate);
HWY_EXPORT(substituteFront);
}  // namespace dxFastStepKernels

namespace {

// Products behind a group, at some 0.1 ns, from which on they are shared, and in how many parts for each thread.
constexpr double kMinShared = 200000;
constexpr unsigned kPartsOfThread = 2;

}  // namespace

void dxFrontFactor::shape(const dxFrontPlan &plan) {
    m_plan = &plan;
    m_panels.resize(plan.panelSize() / kBodyLanes);
    m_updates.resize(plan.updateSize() / kBodyLanes + 1);  // also where no front has rows below
    for (std::vector<double> *const vector : {&m_inverses, &m_diagonals, &m_x}) vector->resize(plan.pivots());
    m_scratch.clear();
}

void dxFrontFactor::reserve(unsigned threads) {
    if (m_scratch.size() >= threads) return;
    m_scratch.resize(threads);
    for (Scratch &scratch : m_scratch) {
        scratch.multipliers.resize(std::size_t(dxFrontNumbers::kMaxGroup) * (m_plan->mostRows() / kBodyLanes + 1));
        scratch.rows.resize(m_plan->mostRows() / kBodyLanes + 1);
    }
}

dxFrontNumbers dxFrontFactor::numbersOf(unsigned front, unsigned share) {
    const dxFrontPlan::Front &planned = m_plan->fronts()[front];
    const std::size_t pivot = m_plan->firstPivotOf(planned.begin);
    return {planned.pivots,
            planned.rows,
            planned.panelStride(),
            planned.updateStride(),
            m_panels.data()->lane + planned.panel,
            m_updates.data()->lane + planned.madeAt,
            m_inverses.data() + pivot,
            m_diagonals.data() + pivot,
            m_scratch[share].multipliers.data()->lane};
}

dxFrontNumbers dxFrontFactor::begin(unsigned front, unsigned share) {
    const dxFrontNumbers numbers = numbersOf(front, share);
    std::fill_n(numbers.panel, m_plan->fronts()[front].panelSize(), 0.0);
    return numbers;
}

// The panel has its blocks of A, and gets what children have for it.
void dxFrontFactor::assemble(unsigned front, const dxFrontNumbers &numbers) {
    for (unsigned pivot = 0; pivot < numbers.pivots; ++pivot) numbers.diagonals[pivot] = numbers.column(pivot)[pivot];
    addUpdates(front, numbers, true);
}

void dxFrontFactor::addUpdates(unsigned front, const dxFrontNumbers &numbers, bool toPivots) {
    const dxFrontPlan::Front &planned = m_plan->fronts()[front];
    for (unsigned i = planned.firstChild; i < planned.endChild; ++i) {
        const dxFrontPlan::Child &child = m_plan->children()[i];
        const dxFrontPlan::Front &other = m_plan->fronts()[child.front];
        const double *const update = m_updates.data()->lane + other.update + (other.pivots - other.firstUpdateLine());
        const dxFrontPlan::Run *const runs = m_plan->runs().data();
        HWY_DYNAMIC_DISPATCH(dxFastStepKernels::addUpdate)
        (numbers, toPivots, runs + child.firstRun, runs + child.endRun, update, other.updateStride());
    }
}

void dxFrontFactor::eliminate(const dxFrontNumbers &numbers) {
    if (!HWY_DYNAMIC_DISPATCH(dxFastStepKernels::eliminateFront)(numbers)) m_isRegular.store(false, std::memory_order_relaxed);
}

// The same with the columns behind each group in parts of as many products.
void dxFrontFactor::eliminate(const dxFrontNumbers &numbers, dxPhaseRunner &phases) {
    const unsigned columns = numbers.columns();
    for (unsigned begin = 0, end = 0; begin < numbers.pivots; begin = end) {
        end = numbers.endOfGroup(begin);
        if (!HWY_DYNAMIC_DISPATCH(dxFastStepKernels::factoriseGroup)(numbers, begin, end))
            return m_isRegular.store(false, std::memory_order_relaxed);
        const unsigned count = columns - end;
        const bool isShared = double(count) * count / 2 * (end - begin) >= kMinShared;
        const unsigned parts = isShared && phases.threads() > 1 ? kPartsOfThread * phases.threads() : 1;
        // Columns become shorter: what lies behind the first `part` parts of the work is in the last sqrt(1 - part/parts) of them.
        const auto cut = [&](unsigned part) { return columns - static_cast<unsigned>(count * std::sqrt(1 - double(part) / parts)); };
        phases.forChunks(parts, [&](unsigned part, unsigned) {
            HWY_DYNAMIC_DISPATCH(dxFastStepKernels::subtractGroup)(numbers, begin, end, cut(part), cut(part + 1));
        });
    }
}

// The update gets what children have for it. They are no longer read then, and make room.
void dxFrontFactor::finish(unsigned front, const dxFrontNumbers &numbers) {
    addUpdates(front, numbers, false);
    const dxFrontPlan::Front &planned = m_plan->fronts()[front];
    double *const updates = m_updates.data()->lane;
    if (planned.update != planned.madeAt) std::copy_n(updates + planned.madeAt, planned.updateSize(), updates + planned.update);
}

void dxFrontFactor::substitute(dxPhaseRunner &phases) {
    const auto &chunks = m_plan->chunks();
    for (std::size_t i = m_plan->top().size(); i-- > 0;) substitute(m_plan->top()[i], 0);
    phases.forChunks(static_cast<unsigned>(chunks.size()), [&](unsigned chunk, unsigned share) {
        for (unsigned i = chunks[chunk].end; i-- > chunks[chunk].begin;) substitute(i, share);
    });
}

void dxFrontFactor::substitute(unsigned front, unsigned share) {
    const dxFrontPlan::Front &planned = m_plan->fronts()[front];
    double *const rows = m_scratch[share].rows.data()->lane;
    std::fill_n(rows, planned.pivots, 0.0);  // as long as they are not known
    double *next = rows + planned.pivots;
    for (unsigned i = planned.firstRow; i < planned.endRow; ++i) {
        const unsigned joint = m_plan->rowJoints()[i];
        next = std::copy(solutionOf(joint), solutionOf(joint + 1), next);
    }
    std::fill(next, rows + planned.panelStride(), 0.0);
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::substituteFront)(numbersOf(front, share), rows);
    std::copy_n(rows, planned.pivots, m_x.data() + m_plan->firstPivotOf(planned.begin));
}
#endif
