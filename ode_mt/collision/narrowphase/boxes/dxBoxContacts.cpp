#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/narrowphase/boxes/dxBoxContacts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "collision/narrowphase/boxes/dxBoxBox.h"
#include "collision/narrowphase/boxes/dxFaceClipping-inl.h"
#include "collision/narrowphase/boxes/dxSeparatingAxes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxBoxKernels {
namespace HWY_NAMESPACE {

// Computes the normal, from the first box to the second. Branch-free: which box a face belongs to and which way the axis points are unpredictable.
HWY_INLINE void findNormal(const dxBoxPair &boxes, const SeparatingAxis &axis, dReal *normal) {
    const dReal sign = kSigns[axis.isInverted];
    if (axis.code <= 6) {
        const unsigned face = static_cast<unsigned>(axis.code) - 1, box = face / 3;
        for (int k = 0; k < 3; ++k) normal[k] = sign * boxes.rotation[box][4 * k + (face - 3 * box)];
        return;
    }
    for (int k = 0; k < 3; ++k) {
        const dReal *const row = boxes.rotation[0] + 4 * k;
        normal[k] = sign * (row[0] * axis.inFirst[0] + row[1] * axis.inFirst[1] + row[2] * axis.inFirst[2]);
    }
}

// Computes a point of the edge of the box that is furthest along the normal, for the second box against it.
template <class Lanes>
HWY_INLINE void findEdge(const dxBoxPair &boxes, const SeparatingAxes<Lanes> &axes, int box, const dReal *normal, dReal *point) {
    alignas(32) dReal along[4];
    axes.onAxes(box, normal).store(along);
    for (int k = 0; k < 3; ++k) point[k] = boxes.position[box][k];
    for (int axis = 0; axis < 3; ++axis) {
        const dReal half = kSigns[(along[axis] > 0) == (box == 1)] * axes.half[box][axis];
        for (int k = 0; k < 3; ++k) point[k] += half * boxes.rotation[box][4 * k + axis];
    }
}

HWY_INLINE dReal product(const dReal *a, const dReal *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Computes the middle between the points where two lines are closest to each other; for parallel lines, between the given points.
HWY_INLINE void findCrossing(const dReal *point1, const dReal *direction1, const dReal *point2, const dReal *direction2,
                             dReal (&middle)[3]) {
    constexpr dReal kParallel = dReal(0.0001);
    const dReal between[3] = {point2[0] - point1[0], point2[1] - point1[1], point2[2] - point1[2]};
    const dReal cosine = product(direction1, direction2);
    const dReal along1 = product(direction1, between), along2 = -product(direction2, between);
    const dReal squaredSine = 1 - cosine * cosine;
    dReal way1 = 0, way2 = 0;
    if (!(squaredSine <= kParallel)) {
        const dReal reciprocal = 1 / squaredSine;
        way1 = (along1 + cosine * along2) * reciprocal;
        way2 = (cosine * along1 + along2) * reciprocal;
    }
    for (int k = 0; k < 3; ++k)
        middle[k] = dReal(0.5) * ((point1[k] + direction1[k] * way1) + (point2[k] + direction2[k] * way2));
}

template <class Lanes>
HWY_INLINE void touchEdges(const dxBoxPair &boxes, const SeparatingAxes<Lanes> &axes, dxBoxContacts &contacts) {
    const int edges[2] = {(contacts.code - 7) / 3, (contacts.code - 7) % 3};
    dReal points[2][3], directions[2][3], middle[3];
    for (int box = 0; box < 2; ++box) {
        findEdge(boxes, axes, box, contacts.normal, points[box]);
        for (int k = 0; k < 3; ++k) directions[box][k] = boxes.rotation[box][4 * k + edges[box]];
    }
    findCrossing(points[0], directions[0], points[1], directions[1], middle);
    for (int k = 0; k < 3; ++k) contacts.position[k][0] = middle[k];
    contacts.depths[0] = contacts.depth;
    contacts.count = 1;
}

template <class Lanes>
HWY_INLINE bool findContacts(const dxBoxPair &boxes, dxBoxContacts &contacts) {
    using Axes = SeparatingAxes<Lanes>;
    Axes axes(boxes);
    SeparatingAxis axis;
    const typename Axes::Answer answer = axes.test(boxes, axis);
    contacts.code = 0;
    if (answer != Axes::kTogether) return answer == Axes::kApart;
    contacts.code = axis.code;
    contacts.depth = -axis.depth;
    findNormal(boxes, axis, contacts.normal);
    if (axis.code > 6)
        touchEdges(boxes, axes, contacts);
    else
        FaceClipping<Lanes>(boxes, axes, axis, contacts).clip();
    return true;
}

bool hasBoxKernel() { return kHasFourLanes; }

bool findBoxContacts(const dxBoxPair &boxes, dxBoxContacts &contacts) {
    if constexpr (kHasFourLanes) return findContacts<FourLanes<dReal>>(boxes, contacts);
    return false;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxBoxKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxBoxKernels {
HWY_EXPORT(findBoxContacts);
HWY_EXPORT(hasBoxKernel);
}  // namespace dxBoxKernels

bool dxHasBoxKernel() { return HWY_DYNAMIC_DISPATCH(dxBoxKernels::hasBoxKernel)(); }

bool dxFindBoxContacts(const dxBoxPair &boxes, dxBoxContacts &contacts) {
    return HWY_DYNAMIC_DISPATCH(dxBoxKernels::findBoxContacts)(boxes, contacts);
}
#endif
