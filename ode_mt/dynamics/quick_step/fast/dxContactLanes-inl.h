// Packs of contacts in vectors, kLanes manifolds at a time.
//
// Included once for each instruction set, inside HWY_NAMESPACE.
#if defined(DX_CONTACT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DX_CONTACT_LANES_INL_H
#undef DX_CONTACT_LANES_INL_H
#else
#define DX_CONTACT_LANES_INL_H
#endif

#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/quick_step/fast/dxLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxContactKernels {
namespace HWY_NAMESPACE {

using namespace dxLaneKernels::HWY_NAMESPACE;

constexpr unsigned kNormal = dxContactLanes::kNormal, kTangent = dxContactLanes::kTangent;

// The motion of A relative to B, as rigid motions at A's centre. An impulse changes it by the contact's response, which includes the masses.
struct RelativeMotion {
    Vector v, w;

    static HWY_INLINE RelativeMotion load(const dxContactPack &pack, unsigned first, const dxSpatialMotion *velocities) {
        const dReal *rows[2][kLanes];
        for (unsigned side = 0; side < 2; ++side)
            for (unsigned i = 0; i < kLanes; ++i) rows[side][i] = velocities[pack.source[side][first + i]].columns;
        const Motion difference = loadDifference(rows[0], rows[1]), bodyB = loadMotion(rows[1]);
        const Vector v = {difference.column[0], difference.column[1], difference.column[2]};
        const Vector w = {bodyB.column[3], bodyB.column[4], bodyB.column[5]};
        return {subtract(v, cross(w, loadVector(pack.dAB, first))), {difference.column[3], difference.column[4], difference.column[5]}};
    }

    static HWY_INLINE RelativeMotion of(const Changes &changeA, const Changes &changeB, const Vector &dAB) {
        return {subtract(subtract(changeA.v, changeB.v), cross(changeB.w, dAB)), subtract(changeA.w, changeB.w)};
    }

    // `row`: of a dxContactResponse
    static HWY_INLINE RelativeMotion of(const dxLaneNumbers *row, unsigned first) { return {loadVector(row, first), loadVector(row + 3, first)}; }

    HWY_INLINE Vector velocityAt(const Vector &rA) const { return add(v, cross(w, rA)); }

    HWY_INLINE RelativeMotion plus(const RelativeMotion &other) const { return {add(v, other.v), add(w, other.w)}; }

    // `row`: of a dxContactResponse
    HWY_INLINE void respond(const dxLaneNumbers *row, Lane impulse, unsigned first) {
        const RelativeMotion response = of(row, first);
        v = add(v, scale(response.v, impulse));
        w = add(w, scale(response.w, impulse));
    }
};

// Returns the largest impulse that a friction row may have beside this impulse of the normal.
HWY_INLINE Lane limitOf(const dxContactLanes &contact, int tangent, Lane normalImpulse, unsigned first) {
    return hn::Add(hn::Mul(loadLanes(contact.friction[tangent], first), normalImpulse), loadLanes(contact.limit[tangent], first));
}

// Calls work(pack, first lane, motion of A relative to B) for kLanes manifolds at a time, of packs of at least `minContacts` contacts.
template <class Work>
HWY_INLINE void forPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, unsigned minContacts, const dxSpatialMotion *velocities,
                         const Work &work) {
    for (unsigned i = begin; i < end; ++i) {
        const dxContactPack &pack = contacts.packs[i];
        if (pack.contactCount < minContacts) continue;
        for (unsigned first = 0; first < dxLanes::kCount; first += kLanes) work(pack, first, RelativeMotion::load(pack, first, velocities));
    }
}

// Returns the responses of a pack whose manifolds have more than one contact; null where there are none.
HWY_INLINE dxContactResponse *responsesOf(const dxContactPacks &contacts, const dxContactPack &pack) {
    return contacts.responses != nullptr && pack.contactCount > 1 ? contacts.responses + pack.firstContact : nullptr;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxContactKernels
HWY_AFTER_NAMESPACE();

#endif
