// Vectors of four numbers: mostly the three coordinates of a point, or numbers for the three axes of a box, and one that is not used. Included once
// per instruction set; the guard is Highway's.
#if defined(ODE_MT_FOUR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_FOUR_LANES_INL_H
#undef ODE_MT_FOUR_LANES_INL_H
#else
#define ODE_MT_FOUR_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include <ode/common.h>

HWY_BEFORE_NAMESPACE();
namespace dxBoxKernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Factors of a number whose sign depends on a condition, without a branch.
constexpr dReal kSigns[2] = {1, -1};

// Number of a lane, or a mask.
using LaneNumber = hwy::MakeUnsigned<dReal>;

// Whether this instruction set has such vectors. Without them the class cannot be instantiated, so its users are templates.
constexpr bool kHasFourLanes = HWY_MAX_BYTES >= 4 * sizeof(dReal);

template <class Real>
class FourLanes {
public:
    using Tag = hn::FixedTag<Real, 4>;
    using Vector = hn::Vec<Tag>;

    FourLanes() = default;
    HWY_INLINE FourLanes(Vector lanes) : m_lanes(lanes) {}
    explicit HWY_INLINE FourLanes(Real all) : m_lanes(hn::Set(Tag(), all)) {}
    // Loads three numbers; the fourth is zero.
    static HWY_INLINE FourLanes three(const Real *from) {
        return hn::MaskedLoad(hn::FirstN(Tag(), 3), Tag(), from);
    }
    static HWY_INLINE FourLanes four(const Real *from) { return hn::LoadU(Tag(), from); }
    HWY_INLINE void store(Real *to) const { hn::StoreU(m_lanes, Tag(), to); }

    HWY_INLINE FourLanes operator+(FourLanes b) const { return hn::Add(m_lanes, b.m_lanes); }
    HWY_INLINE FourLanes operator-(FourLanes b) const { return hn::Sub(m_lanes, b.m_lanes); }
    HWY_INLINE FourLanes operator*(FourLanes b) const { return hn::Mul(m_lanes, b.m_lanes); }
    HWY_INLINE FourLanes operator/(FourLanes b) const { return hn::Div(m_lanes, b.m_lanes); }
    HWY_INLINE FourLanes abs() const { return hn::Abs(m_lanes); }
    HWY_INLINE FourLanes max(FourLanes b) const { return hn::Max(m_lanes, b.m_lanes); }

    // Return a bit for each lane.
    HWY_INLINE unsigned operator<=(FourLanes b) const { return bits(hn::Le(m_lanes, b.m_lanes)); }
    HWY_INLINE unsigned operator<(FourLanes b) const { return bits(hn::Lt(m_lanes, b.m_lanes)); }

    template <int a, int b, int c, int d = 3>
    HWY_INLINE FourLanes pick() const {
        alignas(32) static constexpr LaneNumber lanes[4] = {a, b, c, d};
        return pick(lanes);
    }
    HWY_INLINE FourLanes pick(const LaneNumber *lanes) const {
        return hn::TableLookupLanes(m_lanes, hn::SetTableIndices(Tag(), lanes));
    }
    // Returns these lanes where `isThese` has all bits, the others' where it is 0.
    HWY_INLINE FourLanes orElse(FourLanes others, const LaneNumber *isThese) const {
        const hn::RebindToUnsigned<Tag> d;
        return hn::IfThenElse(hn::MaskFromVec(hn::BitCast(Tag(), hn::Load(d, isThese))), m_lanes, others.m_lanes);
    }

private:
    static HWY_INLINE unsigned bits(hn::Mask<Tag> mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(Tag(), mask, bytes);
        return bytes[0];
    }

    Vector m_lanes;
};

}  // namespace HWY_NAMESPACE
}  // namespace dxBoxKernels
HWY_AFTER_NAMESPACE();

#endif
