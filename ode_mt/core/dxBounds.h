// An axis-aligned box in the layout of dxGeom::aabb: min and max of x, then of y, then of z. Units: world units.
//
// Comparisons are those of upstream's collideAABBs, so a NaN bound overlaps everything on its axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <ode/common.h>

// Two numbers that are compared at once.
using dxTwoReals [[gnu::vector_size(2 * sizeof(dReal))]] = dReal;

// Returns whether one of several comparisons of two numbers was true for any. Each gives 0 or -1; it takes their sum, since GCC extracts the two
// results of a disjunction bit by bit.
template <class Sum>
bool dxIsAny(const Sum &sum) {
    std::uint64_t words[sizeof sum / sizeof(std::uint64_t)], any = 0;
    std::memcpy(words, &sum, sizeof sum);
    for (const std::uint64_t word : words) any |= word;
    return any != 0;
}

// Returns whether two boxes in that layout overlap. All bounds are compared at once: of boxes that lie anywhere, a branch for each is mispredicted,
// which takes four times as long as the comparison.
inline bool dxOverlap(const dReal *a, const dReal *b) {
    using Two = dxTwoReals;
    return !dxIsAny((Two{a[0], b[0]} > Two{b[1], a[1]}) + (Two{a[2], b[2]} > Two{b[3], a[3]}) + (Two{a[4], b[4]} > Two{b[5], a[5]}));
}

// A box that is compared with many: the same as dxOverlap().
class dxBoxProbe {
public:
    explicit dxBoxProbe(const dReal *aabb) : m_ends{{aabb[1], -aabb[0]}, {aabb[3], -aabb[2]}, {aabb[5], -aabb[4]}} {}
    // Overlaps every box.
    static dxBoxProbe ofAny() {
        constexpr dReal nan = std::numeric_limits<dReal>::quiet_NaN();
        const dReal nans[6] = {nan, nan, nan, nan, nan, nan};
        return dxBoxProbe(nans);
    }

    bool overlaps(const dReal *aabb) const {
        return !dxIsAny((endsOf(aabb) > m_ends[0]) + (endsOf(aabb + 2) > m_ends[1]) + (endsOf(aabb + 4) > m_ends[2]));
    }

private:
    // Of a box on one axis: the lower end, and the upper one with the other sign.
    static dxTwoReals endsOf(const dReal *bounds) {
        using Bits = decltype(dxTwoReals{} > dxTwoReals{});
        using Word = std::conditional_t<sizeof(dReal) == sizeof(std::int64_t), std::int64_t, std::int32_t>;
        Bits bits;
        std::memcpy(&bits, bounds, sizeof bits);
        bits ^= Bits{0, std::numeric_limits<Word>::min()};  // no arithmetic, which may flush the smallest numbers to zero
        dxTwoReals ends;
        std::memcpy(&ends, &bits, sizeof ends);
        return ends;
    }

    dxTwoReals m_ends[3];  // by axis: the upper end, and the lower one with the other sign
};

// The same bound by bound: the faster way for a few boxes, whose comparisons come out alike from call to call.
inline bool dxOverlapInTurn(const dReal *a, const dReal *b) {
    return !(a[0] > b[1] || a[1] < b[0] || a[2] > b[3] || a[3] < b[2] || a[4] > b[5] || a[5] < b[4]);
}

struct dxBounds {
    dReal v[6];

    dxBounds() = default;
    explicit dxBounds(const dReal *aabb) { std::memcpy(v, aabb, sizeof v); }

    dReal low(int axis) const { return v[2 * axis]; }
    dReal high(int axis) const { return v[2 * axis + 1]; }

    bool overlaps(const dxBounds &b) const { return dxOverlap(v, b.v); }

    bool contains(const dxBounds &b) const {
        return v[0] <= b.v[0] && b.v[1] <= v[1] && v[2] <= b.v[2] && b.v[3] <= v[3] && v[4] <= b.v[4] &&
               b.v[5] <= v[5];
    }

    // Returns whether all six bounds are finite and no minimum exceeds its maximum.
    bool isProper() const {
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(low(axis)) || !std::isfinite(high(axis)) || low(axis) > high(axis)) return false;
        return true;
    }

    // Returns whether the box is proper, and everything that a broad phase computes from its corners is finite.
    bool isModerate() const {
        constexpr dReal kAstronomical = dReal(1e30);
        for (const dReal bound : v)
            if (!(std::fabs(bound) < kAstronomical)) return false;
        return isProper();
    }

    dReal longestEdge() const {
        dReal longest = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const dReal edge = high(axis) - low(axis);
            if (edge > longest) longest = edge;  // not if it is NaN
        }
        return longest;
    }

    // Of no point: what is included next is all of it.
    static dxBounds nothing() {
        dxBounds box;
        for (int axis = 0; axis < 3; ++axis) {
            box.v[2 * axis] = dInfinity;
            box.v[2 * axis + 1] = -dInfinity;
        }
        return box;
    }

    // NaN is passed over.
    void include(const dxBounds &b) {
        for (int axis = 0; axis < 3; ++axis) includeOn(axis, b.low(axis), b.high(axis));
    }
    void includeOn(int axis, dReal low, dReal high) {
        v[2 * axis] = std::min(v[2 * axis], low);
        v[2 * axis + 1] = std::max(v[2 * axis + 1], high);
    }

    dxBounds grown(dReal margin) const {
        dxBounds box;
        for (int axis = 0; axis < 3; ++axis) {
            box.v[2 * axis] = v[2 * axis] - margin;
            box.v[2 * axis + 1] = v[2 * axis + 1] + margin;
        }
        return box;
    }
};
