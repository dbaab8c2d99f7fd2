#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxMaximumStep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "dynamics/world_step/kernels/dxMaximumStep.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Four: few loops end within a vector, and few rows are lost in it.
using StepTag = hn::CappedTag<dReal, 4>;
using StepVector = hn::Vec<StepTag>;

// Elements from `i` on, and 0 from `end` on: no exception is raised by what lies there.
HWY_INLINE StepVector loadBelow(const dReal *array, unsigned i, unsigned end) {
    const StepTag d;
    const StepVector lanes = hn::LoadU(d, array + i);
    if (i + hn::Lanes(d) <= end) return lanes;
    return hn::IfThenElseZero(hn::FirstN(d, end - i), lanes);
}

unsigned findFirstAtLimit(const dReal *x, const dReal *deltaX, const dxLimitPair *limits, unsigned begin, unsigned end,
                          dReal &length) {
    const StepTag d;
    const StepVector zero = hn::Zero(d);
    unsigned found = end;
    for (unsigned i = begin / hn::Lanes(d) * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
        StepVector delta = loadBelow(deltaX, i, end);
        if (i < begin) delta = hn::IfThenZeroElse(hn::FirstN(d, begin - i), delta);
        const auto isMoving = hn::Ne(delta, zero);
        StepVector low, high;
        static_assert(sizeof(dxLimitPair) == 2 * sizeof(dReal), "pairs lie side by side");
        hn::LoadInterleaved2(d, reinterpret_cast<const dReal *>(limits + i), low, high);
        const StepVector limit = hn::IfThenElseZero(isMoving, hn::IfThenElse(hn::Lt(delta, zero), low, high));
        const StepVector distance = hn::Sub(limit, hn::IfThenElseZero(isMoving, hn::LoadU(d, x + i)));
        const StepVector lengths = hn::Div(distance, hn::IfThenElse(isMoving, delta, hn::Set(d, dReal(1))));
        const auto isBefore = hn::And(isMoving, hn::Lt(lengths, hn::Set(d, length)));
        if (hn::AllFalse(d, isBefore)) continue;
        HWY_ALIGN dReal each[hn::MaxLanes(d)];
        hn::Store(hn::IfThenElse(isBefore, lengths, hn::Set(d, length)), d, each);
        for (unsigned lane = 0; lane < hn::Lanes(d); ++lane) {
            if (!(each[lane] < length)) continue;
            length = each[lane];
            found = i + lane;
        }
    }
    return found;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(findFirstAtLimit);
}  // namespace dxSolve

unsigned dxFindFirstAtLimit(const dReal *x, const dReal *deltaX, const dxLimitPair *limits, unsigned begin,
                            unsigned end, dReal &length) {
    return HWY_DYNAMIC_DISPATCH(dxSolve::findFirstAtLimit)(x, deltaX, limits, begin, end, length);
}
#endif
