#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/broadphase/overlap/dxPackedBoxes.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "collision/broadphase/overlap/dxPackedBoxes.h"
#include "core/dxPrefetch.h"

HWY_BEFORE_NAMESPACE();
namespace dxBroadphaseKernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// In candidates.
constexpr std::size_t kPrefetchDistance = 16;

// The negated test would differ for NaN.
HWY_INLINE bool areApart(const double *HWY_RESTRICT begin, const double *HWY_RESTRICT end) {
    const hn::CappedTag<double, dxPackedBoxes::kLanes> d;
    auto apart = hn::Gt(hn::Load(d, begin), hn::Load(d, end));
    for (std::size_t lane = hn::Lanes(d); lane < dxPackedBoxes::kLanes; lane += hn::Lanes(d))
        apart = hn::Or(apart, hn::Gt(hn::Load(d, begin + lane), hn::Load(d, end + lane)));
    return !hn::AllFalse(d, apart);
}

HWY_INLINE bool mayBePair(dxPackedBoxes::Marks a, dxPackedBoxes::Marks b) {
    const unsigned both = a & b & dxPackedBoxes::kKnown, either = (a | b) & dxPackedBoxes::kChanged;
    return (both != 0) & (either != 0);
}

// Which candidates are pairs is unpredictable: every one is written, and overwritten by the next one if it is no pair (branch-free).
std::size_t overlappingCandidates(const dxPackedBoxes &boxes, const dxSlotPair *HWY_RESTRICT candidates,
                                  std::size_t count, dxSlotPair *HWY_RESTRICT pairs) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i + kPrefetchDistance < count) dxPrefetch::line(boxes.begin(candidates[i + kPrefetchDistance].b));
        const dxSlotPair pair = candidates[i];
        pairs[found] = pair;
        const bool mayBe = mayBePair(boxes.marks(pair.a), boxes.marks(pair.b));
        found += mayBe & !areApart(boxes.begin(pair.b), boxes.end(pair.a));
    }
    return found;
}

std::size_t overlappingSlots(const dxPackedBoxes &boxes, std::size_t slot, std::size_t first, std::size_t end,
                             std::uint32_t *HWY_RESTRICT slots) {
    const double *HWY_RESTRICT const ends = boxes.end(slot);
    const double *HWY_RESTRICT const begins = boxes.begin(0);
    std::size_t found = 0;
    for (std::size_t other = first; other < end; ++other) {
        slots[found] = static_cast<std::uint32_t>(other);
        found += !areApart(begins + dxPackedBoxes::kLanes * other, ends);
    }
    return found;
}

dxOverlappingSlotsKernel kernelOfOverlappingSlots() { return overlappingSlots; }

}  // namespace HWY_NAMESPACE
}  // namespace dxBroadphaseKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxBroadphaseKernels {
HWY_EXPORT(overlappingCandidates);
HWY_EXPORT(kernelOfOverlappingSlots);
}  // namespace dxBroadphaseKernels

void dxPackedBoxes::resize(std::size_t boxes) {
    m_begins.resize(boxes);
    m_ends.resize(boxes);
    m_marks.resize(boxes);
}

std::size_t dxOverlappingCandidates(const dxPackedBoxes &boxes, const dxSlotPair *candidates, std::size_t count,
                                    dxSlotPair *pairs) {
    return HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::overlappingCandidates)(boxes, candidates, count, pairs);
}

dxOverlappingSlotsKernel dxKernelOfOverlappingSlots() {
    return HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::kernelOfOverlappingSlots)();
}
#endif
