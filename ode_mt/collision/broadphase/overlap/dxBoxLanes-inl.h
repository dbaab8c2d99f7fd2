// One box against boxes in columns, as many at a time as a vector holds, for every instruction set.
// Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_BOX_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_BOX_LANES_INL_H
#undef ODE_MT_BOX_LANES_INL_H
#else
#define ODE_MT_BOX_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace dxBroadphaseKernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The box, each of its bounds in all lanes. The comparison is dxBounds::overlaps.
template <class Tag>
class BoxLanes {
public:
    using Real = hn::TFromD<Tag>;
    using Mask = hn::Mask<Tag>;

    explicit BoxLanes(const Real *box) {
        for (int bound = 0; bound < 6; ++bound) m_bounds[bound] = hn::Set(Tag(), box[bound]);
    }
    // Broadcasts the box of a row.
    BoxLanes(const Real *const *columns, std::size_t row) {
        for (int bound = 0; bound < 6; ++bound) m_bounds[bound] = hn::Set(Tag(), columns[bound][row]);
    }

    // Returns the mask of the boxes from row `first` on that are disjoint from it. `columns` is indexed by bound.
    HWY_INLINE Mask apart(const Real *const *columns, std::size_t first) const {
        return hn::Or(apartOn(0, columns, first), hn::Or(apartOn(1, columns, first), apartOn(2, columns, first)));
    }

private:
    // Two boxes are disjoint if one begins after the other ends. The negated test would differ for NaN.
    HWY_INLINE Mask apartOn(int axis, const Real *const *columns, std::size_t first) const {
        const auto low = hn::LoadU(Tag(), columns[2 * axis] + first);
        const auto high = hn::LoadU(Tag(), columns[2 * axis + 1] + first);
        return hn::Or(hn::Gt(m_bounds[2 * axis], high), hn::Lt(m_bounds[2 * axis + 1], low));
    }

    hn::Vec<Tag> m_bounds[6];
};

// Returns a bit for each of the first `valid` lanes that is not in the mask.
template <class Tag>
HWY_INLINE std::uint32_t lanesLeft(Tag d, hn::Mask<Tag> mask, std::size_t valid = hn::Lanes(Tag())) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return ~static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8) & ((std::uint32_t{1} << valid) - 1);
}

// Writes first, first + 1, ..., of all `lanes` lanes.
HWY_INLINE void storeRows(std::uint32_t first, std::size_t lanes, std::uint32_t *HWY_RESTRICT rows) {
    for (std::uint32_t lane = 0; lane < lanes; ++lane) rows[lane] = first + lane;
}

// Calls visit(lane) for each bit.
template <class Visit>
HWY_INLINE void forLanes(std::uint32_t lanes, Visit &&visit) {
    for (; lanes != 0; lanes &= lanes - 1) visit(hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes));
}

}  // namespace HWY_NAMESPACE
}  // namespace dxBroadphaseKernels
HWY_AFTER_NAMESPACE();

#endif
