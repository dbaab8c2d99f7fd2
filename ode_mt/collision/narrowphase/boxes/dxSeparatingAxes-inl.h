// The separating-axis test of two boxes. Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_SEPARATING_AXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_SEPARATING_AXES_INL_H
#undef ODE_MT_SEPARATING_AXES_INL_H
#else
#define ODE_MT_SEPARATING_AXES_INL_H
#endif

#include <hwy/highway.h>

#include <cmath>
#include <limits>

#include "collision/narrowphase/boxes/dxBoxBox.h"
#include "collision/narrowphase/boxes/dxFourLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxBoxKernels {
namespace HWY_NAMESPACE {

// Returns a vector times a matrix, summed in the order of coordinates.
template <class Lanes>
HWY_INLINE Lanes sumOfProducts(const Lanes (&rows)[3], dReal x, dReal y, dReal z) {
    return rows[0] * Lanes(x) + rows[1] * Lanes(y) + rows[2] * Lanes(z);
}

// An axis, and how the boxes lie on it. `depth` is the overlap, as a number that is not positive.
struct SeparatingAxis {
    int code = 0;  // upstream's, or 0: the boxes are apart
    dReal depth;
    bool isInverted;    // it points from the second box to the first
    dReal inFirst[3];  // of two edges: the axis in the frame of the first box
};

// Lanes are the axes of the first box where a name ends with 1, else those of the second. Other names are those of the paper: R is
// the rotation of the second box in the frame of the first, t the position of its centre there.
template <class Lanes>
class SeparatingAxes {
public:
    enum Answer { kApart, kTogether, kUnknown };

    explicit HWY_INLINE SeparatingAxes(const dxBoxPair &boxes)
        : m_rows1{Lanes::three(boxes.rotation[0]), Lanes::three(boxes.rotation[0] + 4), Lanes::three(boxes.rotation[0] + 8)},
          m_rows2{Lanes::three(boxes.rotation[1]), Lanes::three(boxes.rotation[1] + 4), Lanes::three(boxes.rotation[1] + 8)},
          m_half1(Lanes::three(boxes.sides[0]) * Lanes(dReal(0.5))),
          m_half2(Lanes::three(boxes.sides[1]) * Lanes(dReal(0.5))) {
        m_half1.store(half[0]);
        m_half2.store(half[1]);
    }

    HWY_INLINE Answer test(const dxBoxPair &boxes, SeparatingAxis &axis) {
        const Answer answer = testFaces(boxes, axis);
        return answer == kTogether ? testEdges(axis) : answer;
    }

    // Return the products of a vector of the world with the axes of a box.
    HWY_INLINE Lanes onAxes(int box, const dReal *vector) const {
        return sumOfProducts(box == 0 ? m_rows1 : m_rows2, vector[0], vector[1], vector[2]);
    }

    alignas(32) dReal half[2][4];  // half of the sides
    alignas(32) dReal R[12];       // rows of four

private:
    // Bits of three lanes.
    static constexpr unsigned kThree = 7;

    HWY_INLINE Answer testFaces(const dxBoxPair &boxes, SeparatingAxis &axis) {
        const dReal *const R1 = boxes.rotation[0], *const R2 = boxes.rotation[1];
        Lanes columns1[3];  // of R, without signs
        for (int i = 0; i < 3; ++i) {
            m_R[i] = sumOfProducts(m_rows2, R1[i], R1[4 + i], R1[8 + i]);
            columns1[i] = sumOfProducts(m_rows1, R2[i], R2[4 + i], R2[8 + i]).abs();
        }
        const dReal *const p1 = boxes.position[0], *const p2 = boxes.position[1];
        const dReal p[3] = {p2[0] - p1[0], p2[1] - p1[1], p2[2] - p1[2]};
        const Lanes t1 = onAxes(0, p), t2 = onAxes(1, p);
        const Lanes overlap1 = t1.abs() - (m_half1 + Lanes(half[1][0]) * columns1[0] + Lanes(half[1][1]) * columns1[1] +
                                               Lanes(half[1][2]) * columns1[2]);
        const Lanes overlap2 = t2.abs() - (Lanes(half[0][0]) * m_R[0].abs() + Lanes(half[0][1]) * m_R[1].abs() +
                                               Lanes(half[0][2]) * m_R[2].abs() + m_half2);
        const Lanes zero(dReal(0));
        if (((overlap1 <= zero) & (overlap2 <= zero) & kThree) != kThree)
            return (((zero < overlap1) | (zero < overlap2)) & kThree) != 0 ? kApart : kUnknown;
        overlap1.store(m_overlaps);
        overlap2.store(m_overlaps + 3);
        t1.store(m_t);
        t2.store(m_t + 3);
        chooseFace(overlap1, overlap2, axis);
        return axis.depth > -std::numeric_limits<dReal>::infinity() ? kTogether : kUnknown;
    }

    // Takes the first of the axes with the least overlap, branch-free: which one that is is unpredictable.
    HWY_INLINE void chooseFace(Lanes overlap1, Lanes overlap2, SeparatingAxis &axis) {
        const Lanes ofBoth = overlap1.max(overlap2);
        m_least = ofBoth.max(ofBoth.template pick<1, 2, 0>()).max(ofBoth.template pick<2, 0, 1>());
        const unsigned first = (m_least <= overlap1) & kThree, second = (m_least <= overlap2) & kThree;
        const auto at = hwy::Num0BitsBelowLS1Bit_Nonzero32(first | second << 3);
        axis.code = static_cast<int>(at) + 1;
        axis.depth = m_overlaps[at];
        axis.isInverted = m_t[at] < 0;
    }

    HWY_INLINE Answer testEdges(SeparatingAxis &axis) {
        for (int i = 0; i < 3; ++i) m_R[i].store(R + 4 * i);
        const Lanes overlaps[3] = {overlapOfEdges<0>(), overlapOfEdges<1>(), overlapOfEdges<2>()};
        const Lanes zero(dReal(0));
        const unsigned together = (overlaps[0] <= zero) & (overlaps[1] <= zero) & (overlaps[2] <= zero);
        if ((together & kThree) != kThree)
            return (((zero < overlaps[0]) | (zero < overlaps[1]) | (zero < overlaps[2])) & kThree) != 0 ? kApart : kUnknown;
        const Lanes squares[3] = {m_R[0] * m_R[0], m_R[1] * m_R[1], m_R[2] * m_R[2]};
        const Lanes lengths[3] = {squares[2] + squares[1], squares[2] + squares[0], squares[1] + squares[0]};  // squared
        unsigned candidates = 0;
        for (int i = 0; i < 3; ++i) candidates |= (mayOverlapLess(overlaps[i], lengths[i]) & kThree) << 4 * i;
        if (candidates == 0) return kTogether;
        alignas(32) dReal overlap[12], length[12];
        for (int i = 0; i < 3; ++i) {
            overlaps[i].store(overlap + 4 * i);
            lengths[i].store(length + 4 * i);
        }
        int best = -1;
        dReal bestLength = 0;
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto at = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(candidates));
            const dReal l = std::sqrt(length[at]);
            if (!(l > 0)) continue;
            const dReal ofUnit = overlap[at] / l;
            if (!(ofUnit * kPreferenceOfFaces > axis.depth)) continue;
            axis.depth = ofUnit;
            best = at;
            bestLength = l;
        }
        if (best >= 0) takeEdges(best / 4, best % 4, bestLength, axis);
        return kTogether;
    }

    // Two edges give the axis only if their overlap times this factor is less than that of the faces.
    static constexpr dReal kPreferenceOfFaces = dReal(1.05);

    // Returns the overlaps on the axes that are the products of edge i of the first box and the edges of the second.
    template <int i>
    HWY_INLINE Lanes overlapOfEdges() const {
        constexpr int next = (i + 1) % 3, last = (i + 2) % 3;
        const dReal *const A = half[0], *const B = half[1];
        const Lanes distance = Lanes(m_t[last]) * m_R[next] - Lanes(m_t[next]) * m_R[last];
        const Lanes Q = m_R[i].abs();
        const Lanes ofFirst = Lanes(A[next]) * m_R[last].abs() + Lanes(A[last]) * m_R[next].abs();
        const dReal low[4] = {B[1], B[0], B[0], 0}, high[4] = {B[2], B[2], B[1], 0};
        return distance.abs() -
               (ofFirst + Lanes::four(low) * Q.template pick<2, 2, 1>() + Lanes::four(high) * Q.template pick<1, 0, 0>());
    }

    // Returns the lanes in which the overlap, divided by the length and times the preference, may be less than that of the faces. Others need no
    // root and no quotient: their squares differ by far more than rounding may change, unless they are near the smallest
    // numbers.
    HWY_INLINE unsigned mayOverlapLess(Lanes overlap, Lanes squaredLength) const {
        constexpr dReal kLess = dReal(1.1), kSmall = std::numeric_limits<dReal>::min() / std::numeric_limits<dReal>::epsilon();
        static_assert(kLess < dReal(0.999) * kPreferenceOfFaces * kPreferenceOfFaces, "");
        const Lanes square = overlap * overlap, ofFaces = m_least * m_least, small(kSmall);
        return ~((ofFaces * squaredLength < square * Lanes(kLess)) & (small < square) & (small < ofFaces));
    }

    HWY_INLINE void takeEdges(int i, int j, dReal length, SeparatingAxis &axis) const {
        const int next = (i + 1) % 3, last = (i + 2) % 3;
        axis.code = 7 + 3 * i + j;
        axis.isInverted = m_t[last] * R[4 * next + j] - m_t[next] * R[4 * last + j] < 0;
        axis.inFirst[i] = 0 / length;
        axis.inFirst[next] = -R[4 * last + j] / length;
        axis.inFirst[last] = R[4 * next + j] / length;
    }

    Lanes m_rows1[3], m_rows2[3], m_half1, m_half2;
    Lanes m_R[3];
    Lanes m_least;  // overlap of the faces, in every lane
    dReal m_overlaps[8], m_t[8];
};

}  // namespace HWY_NAMESPACE
}  // namespace dxBoxKernels
HWY_AFTER_NAMESPACE();

#endif
