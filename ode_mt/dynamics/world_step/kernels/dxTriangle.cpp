#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxTriangle.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <cmath>
#include <cstddef>

#include "dynamics/world_step/kernels/dxTriangle.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

bool areRowsFinite(const dReal *triangle, std::size_t begin, std::size_t end, std::size_t rowSkip) {
    const hn::ScalableTag<dReal> d;
    auto differences = hn::Zero(d);  // of elements and themselves: 0, or NaN
    dReal last = 0;                  // the same of what makes no whole vector
    for (std::size_t row = begin; row < end; ++row) {
        const dReal *elements = triangle + row * rowSkip;
        std::size_t column = 0;
        for (; column + hn::Lanes(d) <= row + 1; column += hn::Lanes(d)) {
            const auto x = hn::LoadU(d, elements + column);
            differences = hn::Or(differences, hn::Sub(x, x));
        }
        for (; column <= row; ++column) last += elements[column] - elements[column];
    }
    return last == 0 && hn::AllTrue(d, hn::Eq(differences, hn::Zero(d)));
}

void findSkyline(const dReal *triangle, std::size_t n, std::size_t rowSkip, unsigned *begins) {
    const hn::ScalableTag<dReal> d;
    const hn::RebindToUnsigned<decltype(d)> bits;
    for (std::size_t row = 0; row < n; ++row) {
        const dReal *elements = triangle + row * rowSkip;
        std::size_t column = 0;
        while (column + hn::Lanes(d) <= row &&
               hn::AllTrue(bits, hn::Eq(hn::BitCast(bits, hn::LoadU(d, elements + column)), hn::Zero(bits))))
            column += hn::Lanes(d);
        while (column < row && elements[column] == 0 && !std::signbit(elements[column])) ++column;
        begins[row] = static_cast<unsigned>(column);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(areRowsFinite);
HWY_EXPORT(findSkyline);
}  // namespace dxSolve

bool dxAreRowsFinite(const dReal *triangle, unsigned begin, unsigned end, unsigned rowSkip) {
    return HWY_DYNAMIC_DISPATCH(dxSolve::areRowsFinite)(triangle, begin, end, rowSkip);
}

void dxFindSkyline(const dReal *triangle, unsigned n, unsigned rowSkip, unsigned *begins) {
    HWY_DYNAMIC_DISPATCH(dxSolve::findSkyline)(triangle, n, rowSkip, begins);
}
#endif
