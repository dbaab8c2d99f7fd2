// Vectors over one cache line of lanes, for every instruction set. Included once per instruction set; the guard is
// Highway's.
#if defined(ODE_MT_LINE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_LINE_LANES_INL_H
#undef ODE_MT_LINE_LANES_INL_H
#else
#define ODE_MT_LINE_LANES_INL_H
#endif

#include <hwy/highway.h>
#include <ode/common.h>

#include <cstddef>

#include "core/dxCacheLine.h"
#include "dynamics/world_step/kernels/dxTriangleRows.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using LineTag = hn::CappedTag<dReal, kLineLanes>;
using LineVector = hn::Vec<LineTag>;

// sum[r] += L(firstRow + r, column) * y(column) for a vector of lanes, columns begin..end-1 in this order. `y`: a
// line of lanes for each column, from the vector's first lane on.
template <std::size_t Count, class Rows>
HWY_INLINE void addColumns(const Rows &L, std::size_t firstRow, const dReal *y, std::size_t begin, std::size_t end,
                           LineVector *sum) {
    const LineTag d;
    const dReal *row[Count];
    for (std::size_t r = 0; r < Count; ++r) row[r] = L(firstRow + r);
    for (std::size_t column = begin; column < end; ++column) {
        const auto lanes = hn::Load(d, y + column * kLineLanes);
        for (std::size_t r = 0; r < Count; ++r)
            sum[r] = hn::Add(sum[r], hn::Mul(hn::Set(d, row[r][column]), lanes));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#endif
