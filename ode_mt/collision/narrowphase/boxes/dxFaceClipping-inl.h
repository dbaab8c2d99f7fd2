// Contacts of a box with a face of another one: the opposite face, clipped with a rectangle, one side after the other. Included once per instruction
// set; the guard is Highway's.
#if defined(ODE_MT_FACE_CLIPPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_FACE_CLIPPING_INL_H
#undef ODE_MT_FACE_CLIPPING_INL_H
#else
#define ODE_MT_FACE_CLIPPING_INL_H
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "collision/narrowphase/boxes/dxBoxBox.h"
#include "collision/narrowphase/boxes/dxFourLanes-inl.h"
#include "collision/narrowphase/boxes/dxSeparatingAxes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxBoxKernels {
namespace HWY_NAMESPACE {

// Corners in order. A polygon is full at eight: upstream stops there.
struct Polygon {
    static constexpr unsigned kFull = dxBoxContacts::kMax;

    alignas(32) dReal place[2][2 * kFull];  // by coordinate; a full one may have more corners, which do not count
    unsigned corners;
};

// The sides of a rectangle around the origin, in the order of clipping: left, right, below, above.
struct Rectangle {
    static constexpr int kSides = 4;

    explicit HWY_INLINE Rectangle(dReal halfX, dReal halfY) : places{-halfX, halfX, -halfY, halfY} {}

    // Returns for each side the corners that are inside, a bit for each of four.
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

// Clips with one side: corners that are inside stay, and where an edge crosses the side there is a new one. Which corners
// are inside is unpredictable: every one is written, and overwritten by the next one if it does not stay (branch-free).
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

// The result of clipping four corners of which two neighbours stay: which of the old corners each corner of the result is, or which edge (named
// by its first corner) it lies on.
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

// Visits only the sides in `cutting`, a bit for each: sides with all corners inside change nothing. Clips the first of two polygons;
// returns the one that is the result.
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

// Finds the contacts of an incident face with a reference face (dxBoxBox.h).
template <class Lanes>
class FaceClipping {
public:
    HWY_INLINE FaceClipping(const dxBoxPair &boxes, const SeparatingAxes<Lanes> &axes, const SeparatingAxis &axis, dxBoxContacts &contacts)
        : m_contacts(contacts), m_axes(axes), m_reference(axis.code > 3), m_incident(1 - m_reference),
          m_rotation(boxes.rotation[m_incident]), m_face(axis.code - 1 - 3 * m_reference), m_x(m_face == 0), m_y(2 - (m_face == 2)),
          m_sign(kSigns[m_reference] * kSigns[axis.isInverted]) {
        for (int k = 0; k < 3; ++k) m_normal[k] = kSigns[m_reference] * contacts.normal[k];
        m_halfThickness = axes.half[m_reference][m_face];
        placeIncidentFace(boxes);
    }

    HWY_INLINE void clip() {
        const dReal *const half = m_axes.half[m_incident];
        const dReal x1 = m_onX[0] * half[m_u], x2 = m_onX[1] * half[m_v], y1 = m_onY[0] * half[m_u], y2 = m_onY[1] * half[m_v];
        const dReal signs1[4] = {-1, -1, 1, 1}, signs2[4] = {-1, 1, 1, -1};
        const Lanes first = Lanes::four(signs1), second = Lanes::four(signs2);
        Lanes x = Lanes(m_centreX) + first * Lanes(x1) + second * Lanes(x2);
        Lanes y = Lanes(m_centreY) + first * Lanes(y1) + second * Lanes(y2);
        findInverse();
        m_contacts.count = 0;
        const Rectangle rectangle(m_axes.half[m_reference][m_x], m_axes.half[m_reference][m_y]);
        Polygon polygons[2];
        const Polygon *const polygon = clipFour(x, y, rectangle, polygons);
        if (polygon == nullptr) return addPoints(x, y, 4);
        for (unsigned i = 0; i < polygon->corners; i += 4)
            addPoints(Lanes::four(polygon->place[0] + i), Lanes::four(polygon->place[1] + i), polygon->corners - i);
    }

private:
    // The incident face is that whose normal is nearest to the reference face's, inverted.
    HWY_INLINE void placeIncidentFace(const dxBoxPair &boxes) {
        const dReal along[3] = {product(m_face, 0), product(m_face, 1), product(m_face, 2)};
        const dReal size[3] = {std::fabs(along[0]), std::fabs(along[1]), std::fabs(along[2])};
        const int larger = size[1] > size[0], face = size[larger] > size[2] ? larger : 2;
        m_u = face == 0;
        m_v = 2 - (face == 2);
        const dReal half = m_axes.half[m_incident][face], way = -kSigns[m_sign * along[face] < 0] * half;
        m_origin = boxes.position[m_reference];
        for (int k = 0; k < 3; ++k)
            m_centre[k] = boxes.position[m_incident][k] - m_origin[k] + way * m_rotation[4 * k + face];
        const dReal *const frame = boxes.rotation[m_reference];
        m_centreX = m_centre[0] * frame[m_x] + m_centre[1] * frame[4 + m_x] + m_centre[2] * frame[8 + m_x];
        m_centreY = m_centre[0] * frame[m_y] + m_centre[1] * frame[4 + m_y] + m_centre[2] * frame[8 + m_y];
        m_onX[0] = product(m_x, m_u);
        m_onX[1] = product(m_x, m_v);
        m_onY[0] = product(m_y, m_u);
        m_onY[1] = product(m_y, m_v);
    }

    // Returns the product of an axis of the reference box and one of the incident box.
    HWY_INLINE dReal product(int reference, int incident) const {
        return m_axes.R[m_reference == 0 ? 4 * reference + incident : 4 * incident + reference];
    }

    // From the reference face to the incident face, along the normal.
    HWY_INLINE void findInverse() {
        const dReal reciprocal = 1 / (m_onX[0] * m_onY[1] - m_onX[1] * m_onY[0]);
        for (int i = 0; i < 2; ++i) {
            m_inverseX[i] = m_onX[i] * reciprocal;
            m_inverseY[i] = m_onY[i] * reciprocal;
        }
    }

    // Adds the first `corners` of four, as points of the incident face, that are not above the reference face.
    HWY_INLINE void addPoints(Lanes x, Lanes y, unsigned corners) {
        const Lanes fromX = x - Lanes(m_centreX), fromY = y - Lanes(m_centreY);
        const Lanes u = Lanes(m_inverseY[1]) * fromX - Lanes(m_inverseX[1]) * fromY;
        const Lanes v = Lanes(-m_inverseY[0]) * fromX + Lanes(m_inverseX[0]) * fromY;
        const Lanes points[3] = {onIncidentFace(0, u, v), onIncidentFace(1, u, v), onIncidentFace(2, u, v)};
        const Lanes depth = Lanes(m_halfThickness) - sumOfProducts(points, m_normal[0], m_normal[1], m_normal[2]);
        const unsigned valid = (1u << (corners < 4 ? corners : 4)) - 1, kept = (Lanes(dReal(0)) <= depth) & valid;
        const int first = m_contacts.count;
        if (kept == valid) {
            for (int k = 0; k < 3; ++k) (points[k] + Lanes(m_origin[k])).store(m_contacts.position[k] + first);
            depth.store(m_contacts.depths + first);
            x.store(m_contacts.onFace[0] + first);
            y.store(m_contacts.onFace[1] + first);
            m_contacts.count += static_cast<int>(corners < 4 ? corners : 4);
            return;
        }
        alignas(32) dReal place[3][4], depths[4], onFace[2][4];
        for (int k = 0; k < 3; ++k) (points[k] + Lanes(m_origin[k])).store(place[k]);
        depth.store(depths);
        x.store(onFace[0]);
        y.store(onFace[1]);
        for (unsigned left = kept; left != 0; left &= left - 1) {
            const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
            const int to = m_contacts.count++;
            for (int k = 0; k < 3; ++k) m_contacts.position[k][to] = place[k][i];
            m_contacts.depths[to] = depths[i];
            for (int k = 0; k < 2; ++k) m_contacts.onFace[k][to] = onFace[k][i];
        }
    }

    HWY_INLINE Lanes onIncidentFace(int k, Lanes u, Lanes v) const {
        return Lanes(m_centre[k]) + u * Lanes(m_rotation[4 * k + m_u]) + v * Lanes(m_rotation[4 * k + m_v]);
    }

    dxBoxContacts &m_contacts;
    const SeparatingAxes<Lanes> &m_axes;
    const int m_reference, m_incident;  // boxes
    const dReal *const m_rotation;      // of the incident box
    const int m_face, m_x, m_y;         // axes of the reference box: the face's normal and those on it
    const dReal m_sign;                 // of the normal, along that axis
    const dReal *m_origin;              // centre of the reference box, from which points are measured
    dReal m_normal[3];                  // outwards from the reference face
    dReal m_halfThickness;              // from the centre to the reference face
    int m_u, m_v;                       // axes of the incident box, on its face
    dReal m_centre[3];                  // of the incident face
    dReal m_centreX, m_centreY;         // on the reference face
    dReal m_onX[2], m_onY[2];           // of the axes u and v
    dReal m_inverseX[2], m_inverseY[2];  // the same, divided by their determinant
};

}  // namespace HWY_NAMESPACE
}  // namespace dxBoxKernels
HWY_AFTER_NAMESPACE();

#endif
