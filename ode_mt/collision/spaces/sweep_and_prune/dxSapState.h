// What the parts of a sweep-and-prune space share: the bounds of its members along its axes, and the state of the sort.
//
// The cleaner writes boxes, and `absent` for members that are added or removed. The pair order writes parts, positions and, where the axes are not
// x, y and z, boxes. The walker writes `comparisons`. Pair order and walker both sort. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <ode/ode.h>

#include "collision/spaces/sweep_and_prune/dxSapSort.h"
#include "core/dxBounds.h"

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"

// Prefetch distance of the parts of a sweep-and-prune space, in members.
constexpr std::size_t kSapPrefetchDistance = 8;

// The bounds of a geom along the space's three axes. Along the first axis upstream compares in single precision, whose rounding can make boxes touch
// that do not.
struct dxSapBox {
    float low, high;
    dReal low1, high1, low2, high2;
    bool isInfinite;  // infinite upper bound on the first axis: not swept, paired with all

    // Returns whether the boxes overlap. Requires that this box is before `later` in the order, and no NaN in `low`.
    bool meets(const dxSapBox &later) const { return later.low <= high && meetsAcross(later); }
    // Returns whether the boxes overlap along the second and the third axis.
    bool meetsAcross(const dxSapBox &other) const {
        using Two = dxTwoReals;
        const auto meets = (Two{high1, other.high1} >= Two{other.low1, low1}) + (Two{high2, other.high2} >= Two{other.low2, low2});
        return !dxIsAny(meets + 2);
    }
};

// The three axes. They should be x, y and z in any order (dSAP_AXES_XYZ and so on), but need not be: the user's number has two bits for each. For
// axis number 3 upstream reads behind the bounds, where the geom's bits are.
class dxSapAxes {
public:
    explicit dxSapAxes(int order) : m_axes{order & 3, order >> 2 & 3, order >> 4 & 3} {}

    int first() const { return m_axes[0]; }
    // Returns whether each of x, y and z occurs once. Then two boxes of a pair overlap in space.
    bool areAll() const { return (1 << m_axes[0] | 1 << m_axes[1] | 1 << m_axes[2]) == 7; }

    dxSapBox boxOf(const dxGeom *geom) const {
        dxSapBox box;
        readBox(geom, box);
        return box;
    }
    // The same in place: a copy would wait for the stores of the box, which are narrower.
    void readBox(const dxGeom *geom, dxSapBox &box) const {
        const dReal high0 = read(geom, 0, 1);
        box.low = static_cast<float>(read(geom, 0, 0));
        box.high = static_cast<float>(high0);
        box.low1 = read(geom, 1, 0);
        box.high1 = read(geom, 1, 1);
        box.low2 = read(geom, 2, 0);
        box.high2 = read(geom, 2, 1);
        box.isInfinite = high0 == dInfinity;
    }

private:
    // Reads one number at a time: a wider load would wait for the stores of a box that has just been computed.
    dReal read(const dxGeom *geom, int axis, int upper) const {
        if (m_axes[axis] < 3) return geom->aabb[2 * m_axes[axis] + upper];
        const unsigned long bits[2] = {geom->category_bits, geom->collide_bits};
        static_assert(sizeof bits >= 2 * sizeof(dReal), "");
        dReal behind[2];
        std::memcpy(behind, bits, sizeof behind);
        return behind[upper];
    }

    int m_axes[3];
};

enum class dxSapPart : std::uint8_t { absent, swept, infinite };

struct dxSapMember {
    dxSapBox box;            // as of the last cleaning
    std::uint32_t position;  // in the sort, if the member is swept
    dxSapPart part;
};

struct dxSapState {
    explicit dxSapState(int axisOrder) : axes(axisOrder) {}

    const dxSapAxes axes;
    std::vector<dxSapMember> members;  // by slot
    dxSapSort sort;                    // of the keys of the outermost call or of a nested one: upstream has one state for both, too
    std::size_t comparisons = 0;       // number of comparisons in the last sweep of all geoms
};
