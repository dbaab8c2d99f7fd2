#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxMirror.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <algorithm>

#include "dynamics/world_step/kernels/dxMirror.h"
#include "dynamics/world_step/kernels/dxLanes-inl.h"
#include "core/dxCacheLine.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

using MirrorLanes = RowLanes<kLineLanes>;

// Columns begin.. of a line, for the rows before them. Rows beyond the last are read, and ignored.
HWY_INLINE void mirrorLine(const dxMirrorTask &task, std::size_t begin) {
    const MirrorLanes d;
    const auto row = [&](std::size_t index) { return task.rows + index * task.rowSkip; };
    for (std::size_t lane = begin; lane < begin + kLineLanes; lane += hn::Lanes(d)) {
        const auto lanesBelow = [&](std::size_t index) {
            return hn::FirstN(d, index > lane ? std::min(index - lane, hn::Lanes(d)) : 0);
        };
        const auto isThere = hn::AndNot(lanesBelow(task.first), lanesBelow(task.n));
        for (std::size_t j = 0; j < begin; j += 4) {
            const FourColumns<MirrorLanes> four = loadFourColumns(d, row(lane) + j, task.rowSkip);
            for (std::size_t k = 0; k < 4; ++k)
                hn::Store(hn::IfThenElseZero(isThere, four.column[k]), d, row(j + k) + lane);
        }
    }
}

// The rows of the line itself.
HWY_INLINE void mirrorDiagonal(const dxMirrorTask &task, std::size_t begin) {
    const auto row = [&](std::size_t index) { return task.rows + index * task.rowSkip; };
    const std::size_t end = std::min(begin + kLineLanes, task.n);
    for (std::size_t j = begin; j < end; ++j) {
        for (std::size_t i = begin; j < task.first && i < std::min(task.first, end); ++i) row(j)[i] = 0;
        for (std::size_t i = std::max(task.first, j + 1); i < end; ++i) row(j)[i] = row(i)[j];
        for (std::size_t i = end; i < begin + kLineLanes; ++i) row(j)[i] = 0;
    }
}

void mirror(const dxMirrorTask &task) {
    for (std::size_t begin = task.begin; begin < task.end; begin += kLineLanes) {
        mirrorLine(task, begin);
        mirrorDiagonal(task, begin);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(mirror);
}  // namespace dxSolve

void dxMirrorLower(const dxMirrorTask &task) { HWY_DYNAMIC_DISPATCH(dxSolve::mirror)(task); }
#endif
