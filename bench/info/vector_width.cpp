#include "info/vector_width.h"

#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "info/vector_width.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace info::HWY_NAMESPACE {

VectorWidth widthOfTarget() {
    return {hwy::TargetName(HWY_TARGET), static_cast<int>(8 * hwy::HWY_NAMESPACE::Lanes(hwy::HWY_NAMESPACE::ScalableTag<unsigned char>()))};
}

}  // namespace info::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace info {

HWY_EXPORT(widthOfTarget);

VectorWidth vectorWidth() { return HWY_DYNAMIC_DISPATCH(widthOfTarget)(); }

}  // namespace info
#endif
