#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxPanelSolve.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <algorithm>
#include <type_traits>

#include "dynamics/world_step/kernels/dxLanes-inl.h"
#include "dynamics/world_step/kernels/dxPanelSolve.h"
#include "threading/dxTaskRunner.h"
#include "threading/pool/dxOrderedCompletion.h"

// Lanes are right-hand sides: an element of L is one factor for all of them, and nothing is rearranged.
HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

constexpr std::size_t kPanelRows = 8;  // sums in flight: they hide the time of an addition

// Rows first..first+3, whose sums over the columns before them are known. As finishStraightGroup.
HWY_INLINE void finishGroup(const dxSolvePanelTask &task, std::size_t lane, std::size_t first,
                            const LineVector *sum) {
    const LineTag d;
    LineVector y[4];
    for (std::size_t r = 0; r < 4; ++r) {
        const std::size_t row = first + r;
        y[r] =
            hn::Sub(hn::Load(d, task.rightHandSides + task.index[row] * task.rightHandSkip + lane), sum[r]);
        for (std::size_t k = 0; k < r; ++k)
            y[r] = hn::Sub(y[r], hn::Mul(hn::Set(d, task.L[row][first + k]), y[k]));
        hn::Store(y[r], d, task.solutions + row * kLineLanes + lane);
    }
}

// The first column that counts in rows from `first` on.
HWY_INLINE std::size_t beginOf(const dxSolvePanelTask &task, std::size_t first, std::size_t rows) {
    return std::max<std::size_t>(task.skyline.begin(first, rows), task.zeros);
}

// Four or eight rows, whose sums include the columns before `begin`.
template <std::size_t Rows>
HWY_INLINE void finishRows(const dxSolvePanelTask &task, std::size_t lane, std::size_t first, std::size_t begin,
                           LineVector *sum) {
    const dxListedRows L(task.L);
    const dReal *solutions = task.solutions + lane;
    addColumns<Rows>(L, first, solutions, begin, first, sum);
    finishGroup(task, lane, first, sum);
    if constexpr (Rows == 8) {
        LineVector second[4] = {sum[4], sum[5], sum[6], sum[7]};
        addColumns<4>(L, first + 4, solutions, first, first + 4, second);
        finishGroup(task, lane, first + 4, second);
    }
}

template <std::size_t Rows>
HWY_INLINE void solveRows(const dxSolvePanelTask &task, std::size_t lane, std::size_t first) {
    LineVector sum[Rows];
    for (std::size_t r = 0; r < Rows; ++r) sum[r] = hn::Zero(LineTag());
    finishRows<Rows>(task, lane, first, beginOf(task, first, Rows), sum);
}

// Four rows of `Parts` vectors side by side: an element of L is loaded once for all of them, and there are as many sums
// in flight as for eight rows.
template <std::size_t Parts>
HWY_INLINE void solveFourRows(const dxSolvePanelTask &task, std::size_t lane, std::size_t first) {
    const LineTag d;
    const auto laneOf = [&](std::size_t part) { return lane + part * hn::Lanes(d); };
    const dReal *const rows[4] = {task.L[first], task.L[first + 1], task.L[first + 2], task.L[first + 3]};
    LineVector sum[Parts][4];
    for (std::size_t part = 0; part < Parts; ++part)
        for (LineVector &own : sum[part]) own = hn::Zero(d);
    for (std::size_t column = beginOf(task, first, 4); column < first; ++column) {
        LineVector y[Parts];
        for (std::size_t part = 0; part < Parts; ++part)
            y[part] = hn::Load(d, task.solutions + column * kLineLanes + laneOf(part));
        for (std::size_t r = 0; r < 4; ++r) {
            const LineVector factor = hn::Set(d, rows[r][column]);
            for (std::size_t part = 0; part < Parts; ++part)
                sum[part][r] = hn::Add(sum[part][r], hn::Mul(factor, y[part]));
        }
    }
    for (std::size_t part = 0; part < Parts; ++part) finishGroup(task, laneOf(part), first, sum[part]);
}

// Calls take(first, rows) for eight rows at a time, and four at the end: a multiple of four in all.
template <class Take>
HWY_INLINE void forTiles(std::size_t begin, std::size_t end, Take take) {
    for (; begin + kPanelRows <= end; begin += kPanelRows) take(begin, std::integral_constant<std::size_t, kPanelRows>());
    if (begin < end) take(begin, std::integral_constant<std::size_t, 4>());
}

void solvePanel(const dxSolvePanelTask &task) {
    constexpr std::size_t kLanes = hn::MaxLanes(LineTag()), kParts = kLineLanes > kLanes ? 2 : 1;
    const std::size_t end = task.end - (task.end - task.begin) % kPanelRows;
    for (std::size_t lane = 0; task.begin < end && lane < kLineLanes; lane += kLanes)
        for (std::size_t first = task.begin; first < end; first += kPanelRows) solveRows<kPanelRows>(task, lane, first);
    for (std::size_t lane = 0; end < task.end && lane < kLineLanes; lane += kParts * kLanes)
        solveFourRows<kParts>(task, lane, end);
}

// Four or eight rows whose sums are in memory: sum(row) += the products with columns begin..end-1.
template <std::size_t Rows>
HWY_INLINE void addToSums(const dxSolvePanelTask &task, std::size_t lane, std::size_t first, std::size_t begin,
                          std::size_t end, dReal *sums) {
    const LineTag d;
    LineVector sum[Rows];
    for (std::size_t r = 0; r < Rows; ++r) sum[r] = hn::Load(d, sums + r * kLineLanes + lane);
    addColumns<Rows>(dxListedRows(task.L), first, task.solutions + lane, begin, end, sum);
    for (std::size_t r = 0; r < Rows; ++r) hn::Store(sum[r], d, sums + r * kLineLanes + lane);
}

template <std::size_t Rows>
HWY_INLINE void finishFromSums(const dxSolvePanelTask &task, std::size_t lane, std::size_t first, std::size_t begin,
                               const dReal *sums) {
    LineVector sum[Rows];
    for (std::size_t r = 0; r < Rows; ++r) sum[r] = hn::Load(LineTag(), sums + r * kLineLanes + lane);
    finishRows<Rows>(task, lane, first, begin, sum);
}

// Solves the rows of one chunk. Their sums are kept while other workers solve the columns before them.
class RowsInTurn {
public:
    HWY_INLINE RowsInTurn(const dxSolvePanelTask &task, unsigned chunk)
        : m_task(task),
          m_begin(task.begin + chunk * kSharedRows),
          m_end(std::min<std::size_t>(m_begin + kSharedRows, task.end)) {
        std::fill_n(m_sums, kSharedRows * kLineLanes, dReal(0));
    }

    // Adds the products with columns begin..end-1.
    HWY_INLINE void add(std::size_t begin, std::size_t end) {
        forTiles(m_begin, m_end, [&](std::size_t first, auto rows) {
            const std::size_t column = std::max(begin, beginOf(m_task, first, rows));
            for (std::size_t lane = 0; column < end && lane < kLineLanes; lane += hn::Lanes(LineTag()))
                addToSums<rows>(m_task, lane, first, column, end, sums(first));
        });
    }

    // All columns before the rows have been added.
    HWY_INLINE void finish() {
        forTiles(m_begin, m_end, [&](std::size_t first, auto rows) {
            const std::size_t column = std::max(m_begin, beginOf(m_task, first, rows));
            for (std::size_t lane = 0; lane < kLineLanes; lane += hn::Lanes(LineTag()))
                finishFromSums<rows>(m_task, lane, first, column, sums(first));
        });
    }

private:
    HWY_INLINE dReal *sums(std::size_t row) { return m_sums + (row - m_begin) * kLineLanes; }

    const dxSolvePanelTask &m_task;
    const std::size_t m_begin, m_end;
    HWY_ALIGN dReal m_sums[kSharedRows * kLineLanes];
};

void solvePanelOrdered(const dxSolvePanelTask &task, unsigned chunk, dxOrderedCompletion &completion) {
    RowsInTurn rows(task, chunk);
    std::size_t added = 0;
    for (unsigned known = 0;; known = completion.await(known + 1)) {
        const std::size_t end = task.begin + known * kSharedRows;
        rows.add(added, end);
        added = end;
        if (known == chunk) break;
    }
    rows.finish();
    completion.finish(chunk);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(solvePanel);
HWY_EXPORT(solvePanelOrdered);
}  // namespace dxSolve

void dxSolvePanel(const dxSolvePanelTask &task, dxTaskRunner *runner) {
    if (runner == nullptr) return HWY_DYNAMIC_DISPATCH(dxSolve::solvePanel)(task);
    dxOrderedCompletion completion;
    runner->forBlocks(dxParallelStage::PanelSolve, (task.end - task.begin + kSharedRows - 1) / kSharedRows,
        [&](unsigned chunk, unsigned) {
        HWY_DYNAMIC_DISPATCH(dxSolve::solvePanelOrdered)(task, chunk, completion);
    });
}
#endif
