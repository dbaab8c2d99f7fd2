#include "simd/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/overlap/dxBoxTable.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "collision/overlap/dxBoxTable.h"

HWY_BEFORE_NAMESPACE();
namespace dxOverlap {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

std::size_t overlappingRows(const dxBoxTable &table, const dxBounds &box, std::size_t begin,
                            std::uint32_t *HWY_RESTRICT rows) {
    const hn::ScalableTag<dReal> d;
    const dReal *const column[6] = {table.column(0), table.column(1), table.column(2),
                                    table.column(3), table.column(4), table.column(5)};
    hn::Vec<decltype(d)> own[6];
    for (int bound = 0; bound < 6; ++bound) own[bound] = hn::Set(d, box.v[bound]);
    std::size_t count = 0;
    for (std::size_t first = begin; first < table.size(); first += hn::Lanes(d)) {
        // Apart, if one begins after the other ends; not "together, if ...", because of NaN.
        const auto apartOn = [&](int axis) HWY_ATTR {
            const auto low = hn::LoadU(d, column[2 * axis] + first);
            const auto high = hn::LoadU(d, column[2 * axis + 1] + first);
            return hn::Or(hn::Gt(own[2 * axis], high), hn::Lt(own[2 * axis + 1], low));
        };
        const auto apart = hn::Or(apartOn(0), hn::Or(apartOn(1), apartOn(2)));
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, apart, bytes);
        std::uint64_t together = ~static_cast<std::uint64_t>(bytes[0] | bytes[1] << 8);
        const std::size_t valid = std::min(hn::Lanes(d), table.size() - first);
        together &= (std::uint64_t{1} << valid) - 1;
        for (; together != 0; together &= together - 1)
            rows[count++] = static_cast<std::uint32_t>(first + hwy::Num0BitsBelowLS1Bit_Nonzero64(together));
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
