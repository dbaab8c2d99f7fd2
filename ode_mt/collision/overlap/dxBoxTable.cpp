#include "simd/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/overlap/dxBoxTable.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>

#include "collision/overlap/dxBoxLanes-inl.h"
#include "collision/overlap/dxBoxTable.h"

HWY_BEFORE_NAMESPACE();
namespace dxOverlap {
namespace HWY_NAMESPACE {
std::size_t overlappingRows(const dxBoxTable &table, const dxBounds &box, std::size_t begin,
                            std::uint32_t *HWY_RESTRICT rows) {
    const hn::ScalableTag<dReal> d;
    const dReal *const columns[6] = {table.column(0), table.column(1), table.column(2),
                                     table.column(3), table.column(4), table.column(5)};
    const BoxLanes<decltype(d)> own(box.v);
    std::size_t count = 0;
    for (std::size_t first = begin; first < table.size(); first += hn::Lanes(d)) {
        const std::size_t valid = std::min(hn::Lanes(d), table.size() - first);
        forLanes(lanesLeft(d, own.apart(columns, first), valid),
                 [&](std::size_t lane) HWY_ATTR { rows[count++] = static_cast<std::uint32_t>(first + lane); });
    }
    return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxOverlap
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxOverlap {
HWY_EXPORT(overlappingRows);
}  // namespace dxOverlap

std::size_t dxOverlappingRows(const dxBoxTable &table, const dxBounds &box, std::size_t first,
                              std::uint32_t *rows) {
    return HWY_DYNAMIC_DISPATCH(dxOverlap::overlappingRows)(table, box, first, rows);
}
#endif
