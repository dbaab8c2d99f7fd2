#include "simd/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/solve/dxPanelSolve.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <algorithm>

#include "dynamics/solve/dxLineLanes-inl.h"
#include "dynamics/solve/dxPanelSolve.h"

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
            y[r] = hn::Sub(y[r], hn::Mul(hn::Set(d, task.L[row * task.rowSkip + first + k]), y[k]));
        hn::Store(y[r], d, task.solutions + row * kLineLanes + lane);
    }
}

// Four or eight rows.
template <std::size_t Rows>
HWY_INLINE void solveRows(const dxSolvePanelTask &task, std::size_t lane, std::size_t first) {
    LineVector sum[Rows];
    for (std::size_t r = 0; r < Rows; ++r) sum[r] = hn::Zero(LineTag());
    const dReal *row = task.L + first * task.rowSkip, *solutions = task.solutions + lane;
    const std::size_t begin = std::max<std::size_t>(task.envelope.begin(first, Rows), task.zeros);
    addColumns<Rows>(row, task.rowSkip, solutions, begin, first, sum);
    finishGroup(task, lane, first, sum);
    if constexpr (Rows == 8) {
        LineVector second[4] = {sum[4], sum[5], sum[6], sum[7]};
        addColumns<4>(row + 4 * task.rowSkip, task.rowSkip, solutions, first, first + 4, second);
        finishGroup(task, lane, first + 4, second);
    }
}

void solvePanel(const dxSolvePanelTask &task) {
    const LineTag d;
    for (std::size_t lane = 0; lane < kLineLanes; lane += hn::Lanes(d)) {
        std::size_t row = task.begin;
        for (; row + kPanelRows <= task.end; row += kPanelRows) solveRows<kPanelRows>(task, lane, row);
        for (; row < task.end; row += 4) solveRows<4>(task, lane, row);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(solvePanel);
}  // namespace dxSolve

void dxSolvePanel(const dxSolvePanelTask &task) { HWY_DYNAMIC_DISPATCH(dxSolve::solvePanel)(task); }
#endif
