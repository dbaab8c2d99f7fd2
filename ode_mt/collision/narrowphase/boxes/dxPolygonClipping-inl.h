// Clipping of polygons with a rectangle, side by side. Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_POLYGON_CLIPPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_POLYGON_CLIPPING_INL_H
#undef ODE_MT_POLYGON_CLIPPING_INL_H
#else
#define ODE_MT_POLYGON_CLIPPING_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <utility>

#include "collision/narrowphase/boxes/dxBoxContacts.h"
#include "collision/narrowphase/boxes/dxFourLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxBoxKernels {
namespace HWY_NAMESPACE {

// Corners in order. It is full at eight: upstream stops there.
struct Polygon {
    static constexpr unsigned kFull = dxBoxContacts::kMax;

    alignas(32) dReal place[2][2 * kFull];  // by coordinate; of a full one some are behind those that count
    unsigned corners;
};

// The sides of a rectangle around the origin, in the order of clipping: left, right, below, above.
struct Rectangle {
    static constexpr int kSides = 4;

    explicit HWY_INLINE Rectangle(dReal halfX, dReal halfY) : places{-halfX, halfX, -halfY, halfY} {}

    // Returns of each side the corners that are inside, a bit for each of four.
    template <class Lanes>
    HWY_INLINE void inside(Lanes x, Lanes y, unsigned (&corners)[kSides]) const {
        corners[0] = Lanes(places[0]) < x;
        corners[1] = x < Lanes(places[1]);
        corners[2] = Lanes(places[2]) < y;
        corners[3] = y < Lanes(places[3]);
    }

    // Returns the sides for which not all corners are inside, a bit for each.
    static HWY_INLINE unsigned cutting(const unsigned (&inside)[kSides], unsigned all) {
        unsigned sides = 0;
        for (int side = 0; side < kSides; ++side) sides |= static_cast<unsigned>(inside[side] != all) << side;
        return sides;
    }

    dReal places[kSides];
};

// Clips with one side: of the corners those that are inside stay, and where an edge crosses the side there is a new one. Which corners
// are inside is unpredictable: every one is written, and the next one over it if it does not stay.
HWY_INLINE void clipWithSide(const Polygon &from, unsigned stays, int axis, dReal side, Polygon &to) {
    const unsigned corners = from.corners;
    unsigned crosses = stays ^ (stays >> 1 | (stays & 1) << (corners - 1)), slots[Polygon::kFull], size = 0;
    const auto keep = [&](unsigned i) HWY_ATTR {
        to.place[0][size] = from.place[0][i];
        to.place[1][size] = from.place[1][i];
        size += stays >> i & 1;
        slots[i] = size;
        size += crosses >> i & 1;
    };
    for (unsigned i = 0; i < 4; ++i) keep(i);
    for (unsigned i = 4; i < corners; ++i) keep(i);
    to.corners = size;
    const int other = 1 - axis;
    for (; crosses != 0; crosses &= crosses - 1) {
        const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(crosses), next = i + 1 == corners ? 0 : i + 1;
        const dReal *const along = from.place[other], *const across = from.place[axis];
        to.place[other][slots[i]] = along[i] + (along[next] - along[i]) / (across[next] - across[i]) * (side - across[i]);
        to.place[axis][slots[i]] = side;
    }
}

// What becomes of four corners of which two neighbours stay: of the result, which of the old corners each one is, or which edge (named
// by its first corner) it is on.
struct Halving {
    LaneNumber corners[4], edges[4];
    LaneNumber isCorner[4], isOnEdge[4];  // masks of the result, and of the edges that cross the side

    static HWY_INLINE const Halving *of(unsigned stays) {
        constexpr LaneNumber kAll = ~LaneNumber{0};
        alignas(32) static constexpr Halving kHalvings[4] = {
            {{0, 1, 0, 0}, {0, 0, 1, 3}, {kAll, kAll, 0, 0}, {0, kAll, 0, kAll}},   // 0 and 1
            {{0, 1, 2, 0}, {0, 0, 0, 2}, {0, kAll, kAll, 0}, {kAll, 0, kAll, 0}},   // 1 and 2
            {{0, 2, 3, 0}, {1, 0, 0, 3}, {0, kAll, kAll, 0}, {0, kAll, 0, kAll}},   // 2 and 3
            {{0, 0, 0, 3}, {0, 0, 2, 0}, {kAll, 0, 0, kAll}, {kAll, 0, kAll, 0}}};  // 3 and 0
        switch (stays) {
            case 3: return &kHalvings[0];
            case 6: return &kHalvings[1];
            case 12: return &kHalvings[2];
            case 9: return &kHalvings[3];
            default: return nullptr;
        }
    }

    // Clips with one side. `across` is the coordinate that the side has a value of.
    template <class Lanes>
    HWY_INLINE void clip(Lanes &along, Lanes &across, dReal side) const {
        const Lanes place(side);
        const Lanes run = across.template pick<1, 2, 3, 0>() - across, rise = along.template pick<1, 2, 3, 0>() - along;
        const Lanes crossing = along + rise / run.orElse(Lanes(dReal(1)), isOnEdge) * (place - across);
        along = along.pick(corners).orElse(crossing.pick(edges), isCorner);
        across = across.pick(corners).orElse(place, isCorner);
    }
};

// Sides with all corners inside change nothing: only the others, of which `cutting` has a bit, are visited. Of two polygons the first is
// clipped; returns the one that is the result.
template <class Lanes>
HWY_INLINE const Polygon *clipMore(Polygon (&polygons)[2], unsigned (&inside)[Rectangle::kSides], unsigned cutting,
                                   const Rectangle &rectangle) {
    Polygon *polygon = &polygons[0], *spare = &polygons[1];
    while (cutting != 0) {
        const unsigned side = hwy::Num0BitsBelowLS1Bit_Nonzero32(cutting);
        clipWithSide(*polygon, inside[side], side >> 1, rectangle.places[side], *spare);
        std::swap(polygon, spare);
        const unsigned corners = polygon->corners;
        if (corners == 0) break;
        if (corners >= Polygon::kFull) {
            polygon->corners = Polygon::kFull;
            break;
        }
        for (unsigned i = corners; i % 4 != 0; ++i)
            for (dReal *const place : {polygon->place[0], polygon->place[1]}) place[i] = place[0];
        const unsigned all = (1u << corners) - 1;
        rectangle.inside(Lanes::four(polygon->place[0]), Lanes::four(polygon->place[1]), inside);
        if (corners > 4) {
            unsigned high[Rectangle::kSides];
            rectangle.inside(Lanes::four(polygon->place[0] + 4), Lanes::four(polygon->place[1] + 4), high);
            for (int i = 0; i < Rectangle::kSides; ++i) inside[i] |= high[i] << 4;
        }
        for (unsigned &those : inside) those &= all;
        cutting = Rectangle::cutting(inside, all) & 14u << side;
    }
    return polygon;
}

// Clips four corners. Returns NULL if the lanes suffice for the result, else one of the polygons.
template <class Lanes>
HWY_INLINE const Polygon *clipFour(Lanes &x, Lanes &y, const Rectangle &rectangle, Polygon (&polygons)[2]) {
    unsigned toVisit = 15;
    for (;;) {
        unsigned inside[Rectangle::kSides];
        rectangle.inside(x, y, inside);
        const unsigned cutting = Rectangle::cutting(inside, 15) & toVisit;
        if (cutting == 0) return nullptr;
        const unsigned side = hwy::Num0BitsBelowLS1Bit_Nonzero32(cutting);
        const Halving *const halving = Halving::of(inside[side]);
        if (halving == nullptr) {
            x.store(polygons[0].place[0]);
            y.store(polygons[0].place[1]);
            polygons[0].corners = 4;
            return clipMore<Lanes>(polygons, inside, cutting, rectangle);
        }
        if (side < 2)
            halving->clip(y, x, rectangle.places[side]);
        else
            halving->clip(x, y, rectangle.places[side]);
        toVisit = 14u << side;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxBoxKernels
HWY_AFTER_NAMESPACE();

#endif
