// Vectors over the lanes of a body, for every instruction set. Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_BODY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_BODY_LANES_INL_H
#undef ODE_MT_BODY_LANES_INL_H
#else
#define ODE_MT_BODY_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "dynamics/world_step/fast/dxBodyBlocks.h"

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using BodyTag = hn::CappedTag<double, kBodyLanes>;

// The sum of eight lanes' products: halves are added until one is left, so that its order is the same for every width.
HWY_INLINE double addUp(const double *lanes) {
    const double a = lanes[0] + lanes[4], b = lanes[1] + lanes[5], c = lanes[2] + lanes[6], d = lanes[3] + lanes[7];
    return (a + c) + (b + d);
}

// Calls work(count), a joint's number of rows being a constant in it, so that loops over rows are unrolled.
template <class Work>
HWY_INLINE void withRows(unsigned rows, const Work &work) {
    switch (rows) {
        case 1: return work(std::integral_constant<unsigned, 1>());
        case 2: return work(std::integral_constant<unsigned, 2>());
        case 3: return work(std::integral_constant<unsigned, 3>());
        case 4: return work(std::integral_constant<unsigned, 4>());
        case 5: return work(std::integral_constant<unsigned, 5>());
        default: return work(std::integral_constant<unsigned, kBodyAxes>());
    }
}

// J inv(M) of one body, a lane for each row: columns of kLanes numbers. Without the linear columns if they are not wanted.
template <unsigned kLanes, bool kHasLinear>
HWY_INLINE void multiplyByInverseMass(const double *rows, const dxInverseMass &inverse, double *product) {
    const hn::CappedTag<double, kLanes> d;
    for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
        const auto mass = hn::Set(d, inverse.mass);
        for (unsigned k = 0; k < 3 && kHasLinear; ++k)
            hn::Store(hn::Mul(hn::Load(d, rows + k * kLanes + lane), mass), d, product + k * kLanes + lane);
        const auto x = hn::Load(d, rows + 3 * kLanes + lane), y = hn::Load(d, rows + 4 * kLanes + lane),
                   z = hn::Load(d, rows + 5 * kLanes + lane);
        for (unsigned k = 0; k < 3; ++k) {
            const auto sum = hn::Add(hn::Mul(x, hn::Set(d, inverse.inertia[0][k])), hn::Mul(y, hn::Set(d, inverse.inertia[1][k])));
            hn::Store(hn::Add(sum, hn::Mul(z, hn::Set(d, inverse.inertia[2][k]))), d, product + (3 + k) * kLanes + lane);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#endif
