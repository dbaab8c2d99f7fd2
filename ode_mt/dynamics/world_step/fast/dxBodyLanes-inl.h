// Vectors over the lanes of a body, for every instruction set. Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_BODY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_BODY_LANES_INL_H
#undef ODE_MT_BODY_LANES_INL_H
#else
#define ODE_MT_BODY_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "dynamics/world_step/fast/dxBodyBlocks.h"

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using BodyTag = hn::CappedTag<double, kBodyLanes>;

// The sum of eight lanes' products: halves are added until one is left, so that its order is the same for every width.
HWY_INLINE double addUp(const double *lanes) {
    const double a = lanes[0] + lanes[4], b = lanes[1] + lanes[5], c = lanes[2] + lanes[6], d = lanes[3] + lanes[7];
    return (a + c) + (b + d);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxDirect
HWY_AFTER_NAMESPACE();

#endif
