// Contacts of a box with a face of another one. Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_FACE_CLIPPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_FACE_CLIPPING_INL_H
#undef ODE_MT_FACE_CLIPPING_INL_H
#else
#define ODE_MT_FACE_CLIPPING_INL_H
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>

#include "collision/narrowphase/boxes/dxBoxContacts.h"
#include "collision/narrowphase/boxes/dxFourLanes-inl.h"
#include "collision/narrowphase/boxes/dxPolygonClipping-inl.h"
#include "collision/narrowphase/boxes/dxSeparatingAxes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxBoxKernels {
namespace HWY_NAMESPACE {

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
    // The incident face is that whose normal is nearest to the reference face's, turned round.
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

    // Of an axis of the reference box and one of the incident box.
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
