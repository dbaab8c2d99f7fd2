#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/iterative/dxContactSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "dynamics/iterative/dxBodyTranspose-inl.h"
#include "dynamics/iterative/dxContactSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxIterative {
namespace HWY_NAMESPACE {

HWY_INLINE Lane loadLanes(const dxLaneNumbers &numbers, unsigned first) { return hn::Load(LaneTag(), numbers.lane + first); }
HWY_INLINE void storeLanes(Lane lanes, dxLaneNumbers &numbers, unsigned first) {
    hn::Store(lanes, LaneTag(), numbers.lane + first);
}

struct Vector {
    Lane x, y, z;
};

HWY_INLINE Vector loadVector(const dxLaneNumbers *numbers, unsigned first) {
    return {loadLanes(numbers[0], first), loadLanes(numbers[1], first), loadLanes(numbers[2], first)};
}

HWY_INLINE void storeVector(const Vector &vector, dxLaneNumbers *numbers, unsigned first) {
    storeLanes(vector.x, numbers[0], first);
    storeLanes(vector.y, numbers[1], first);
    storeLanes(vector.z, numbers[2], first);
}

HWY_INLINE Lane dot(const Vector &a, const Vector &b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vector add(const Vector &a, const Vector &b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE Vector subtract(const Vector &a, const Vector &b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE Vector scale(const Vector &a, Lane factor) {
    return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

// A NaN stays one, on every instruction set.
HWY_INLINE Lane atLeast(Lane low, Lane a) { return hn::IfThenElse(hn::Lt(a, low), low, a); }
HWY_INLINE Lane clamp(Lane limit, Lane a) { return hn::IfThenElse(hn::Gt(a, limit), limit, atLeast(hn::Neg(limit), a)); }

HWY_INLINE Vector cross(const Vector &a, const Vector &b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

// The inverse masses of the bodies on one side.
struct Masses {
    Lane inverse, xx, xy, xz, yy, yz, zz;

    static HWY_INLINE Masses load(const dxContactPack &pack, unsigned side, unsigned first) {
        const dxLaneNumbers *const inertia = pack.inverseInertia[side];
        return {loadLanes(pack.inverseMass[side], first),
                loadLanes(inertia[0], first),
                loadLanes(inertia[1], first),
                loadLanes(inertia[2], first),
                loadLanes(inertia[3], first),
                loadLanes(inertia[4], first),
                loadLanes(inertia[5], first)};
    }

    HWY_INLINE Vector turn(const Vector &a) const {
        return {hn::Add(hn::Add(hn::Mul(xx, a.x), hn::Mul(xy, a.y)), hn::Mul(xz, a.z)),
                hn::Add(hn::Add(hn::Mul(xy, a.x), hn::Mul(yy, a.y)), hn::Mul(yz, a.z)),
                hn::Add(hn::Add(hn::Mul(xz, a.x), hn::Mul(yz, a.y)), hn::Mul(zz, a.z))};
    }
};

// The velocities of the bodies on one side.
struct Bodies {
    Vector v, w;

    static HWY_INLINE Bodies load(const dxContactPack &pack, unsigned side, unsigned first, const dxVelocity *velocities) {
        const dReal *rows[kLanes];
        for (unsigned i = 0; i < kLanes; ++i) rows[i] = velocities[pack.source[side][first + i]].columns;
        const Motion motion = loadMotion(rows);
        return {{motion.v[0], motion.v[1], motion.v[2]}, {motion.w[0], motion.w[1], motion.w[2]}};
    }

    // Bodies that do not move are written elsewhere.
    HWY_INLINE void store(const dxContactPack &pack, unsigned side, unsigned first, dxVelocity *velocities,
                          dxVelocity &elsewhere) const {
        dReal *rows[kLanes];
        for (unsigned i = 0; i < kLanes; ++i) {
            const int target = pack.target[side][first + i];
            rows[i] = target == dxContactPack::kNoBody ? elsewhere.columns : velocities[target].columns;
        }
        storeMotion({{v.x, v.y, v.z}, {w.x, w.y, w.z}}, rows);
    }

    HWY_INLINE Vector velocityAt(const Vector &arm) const { return add(v, cross(w, arm)); }

    HWY_INLINE void push(const Masses &masses, const Vector &arm, const Vector &impulse) {
        v = add(v, scale(impulse, masses.inverse));
        w = add(w, masses.turn(cross(arm, impulse)));
    }

    HWY_INLINE void pull(const Masses &masses, const Vector &arm, const Vector &impulse) {
        v = subtract(v, scale(impulse, masses.inverse));
        w = subtract(w, masses.turn(cross(arm, impulse)));
    }
};

// A sum for each lane, whatever the width of vectors.
struct Energy {
    HWY_ALIGN dReal lane[dxLanes::kCount] = {};

    HWY_INLINE void add(Lane energy, unsigned first) {
        hn::Store(hn::Add(hn::Load(LaneTag(), lane + first), energy), LaneTag(), lane + first);
    }
    HWY_INLINE double sum() const {
        double sum = 0;
        for (const dReal energy : lane) sum += energy;
        return sum;
    }
};

// 0 for 0, without a division by it: a program may trap that.
HWY_INLINE Lane inverseOf(Lane a) {
    const Lane one = hn::Set(LaneTag(), dReal(1)), none = hn::Zero(LaneTag());
    const auto isNone = hn::Eq(a, none);
    return hn::IfThenElse(isNone, none, hn::Div(one, hn::IfThenElse(isNone, one, a)));
}

// Two directions that are normal to one of length 1, as upstream's dPlaneSpace chooses the first one: horizontal, unless the
// normal is nearly so.
HWY_INLINE Vector tangentOf(const Vector &normal) {
    const LaneTag d;
    const Lane none = hn::Zero(d);
    const auto isSteep = hn::Gt(hn::Abs(normal.z), hn::Set(d, dReal(0.70710678118654752440)));
    const Lane a = hn::IfThenElse(isSteep, normal.y, normal.x), b = hn::IfThenElse(isSteep, normal.z, normal.y);
    const Lane square = hn::Add(hn::Mul(a, a), hn::Mul(b, b));
    const Lane inverse = inverseOf(hn::Sqrt(square));
    const Lane first = hn::Mul(hn::Neg(b), inverse), second = hn::Mul(a, inverse);
    return {hn::IfThenElse(isSteep, none, first), hn::IfThenElse(isSteep, first, second), hn::IfThenElse(isSteep, second, none)};
}

// What a friction row may have at the most, where the normal has the impulse `pressure`.
HWY_INLINE Lane limitOf(const dxContactLanes &contact, int tangent, Lane pressure, unsigned first) {
    return hn::Add(hn::Mul(loadLanes(contact.friction[tangent], first), pressure), loadLanes(contact.limit[tangent], first));
}

HWY_INLINE Lane prepareContact(const dxContactPack &pack, dxContactLanes &contact, unsigned first, const Bodies &body1,
                               const Bodies &body2) {
    const LaneTag d;
    const Lane none = hn::Zero(d);
    const Masses masses1 = Masses::load(pack, 0, first), masses2 = Masses::load(pack, 1, first);
    const Vector arm1 = loadVector(contact.arm[0], first), arm2 = loadVector(contact.arm[1], first);
    const Vector normal = loadVector(contact.direction[0], first), given = loadVector(contact.direction[1], first);
    const auto isGiven = hn::Gt(hn::Add(hn::Add(hn::Abs(given.x), hn::Abs(given.y)), hn::Abs(given.z)), none);
    const Vector found = tangentOf(normal);
    const Vector tangent = {hn::IfThenElse(isGiven, given.x, found.x), hn::IfThenElse(isGiven, given.y, found.y),
                            hn::IfThenElse(isGiven, given.z, found.z)};
    const Vector direction[3] = {normal, tangent, cross(normal, tangent)};
    const Vector force = loadVector(contact.impulse, first);
    Vector turned1[3], turned2[3], axis1[3], axis2[3];
    for (int i = 0; i < 3; ++i) {
        storeVector(direction[i], contact.direction[i], first);
        axis1[i] = cross(arm1, direction[i]);
        axis2[i] = cross(arm2, direction[i]);
        turned1[i] = masses1.turn(axis1[i]);
        turned2[i] = masses2.turn(axis2[i]);
    }
    const Lane inverseMass = hn::Add(masses1.inverse, masses2.inverse);
    const auto couple = [&](int i, int k) {
        return hn::Add(hn::Mul(inverseMass, dot(direction[i], direction[k])),
                       hn::Add(dot(axis1[i], turned1[k]), dot(axis2[i], turned2[k])));
    };
    storeLanes(couple(0, 1), contact.coupling[0], first);
    storeLanes(couple(0, 2), contact.coupling[1], first);
    storeLanes(couple(1, 2), contact.coupling[2], first);
    for (int i = 0; i < 3; ++i) {
        const Lane diagonal = hn::Add(couple(i, i), loadLanes(contact.softness[i], first));
        storeLanes(inverseOf(diagonal), contact.inverse[i], first);
        const Lane impulse = dot(force, direction[i]);
        storeLanes(i == 0 ? atLeast(none, impulse) : impulse, contact.impulse[i], first);
    }
    for (int i = 1; i < 3; ++i) {
        const Lane limit = limitOf(contact, i - 1, loadLanes(contact.impulse[0], first), first);
        storeLanes(clamp(limit, loadLanes(contact.impulse[i], first)), contact.impulse[i], first);
    }
    const Vector relative = subtract(body1.velocityAt(arm1), body2.velocityAt(arm2));
    const Lane residual = atLeast(none, hn::Sub(loadLanes(contact.wanted[0], first), dot(normal, relative)));
    return hn::Mul(hn::Mul(residual, residual), loadLanes(contact.inverse[0], first));
}

double prepare(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities) {
    Energy energy;
    for (unsigned i = begin; i < end; ++i) {
        const dxContactPack &pack = contacts.packs[i];
        for (unsigned first = 0; first < dxLanes::kCount; first += kLanes) {
            const Bodies body1 = Bodies::load(pack, 0, first, velocities), body2 = Bodies::load(pack, 1, first, velocities);
            for (unsigned k = 0; k < pack.contactCount; ++k)
                energy.add(prepareContact(pack, contacts.contacts[pack.firstContact + k], first, body1, body2), first);
        }
    }
    return energy.sum();
}

// Calls work(pack, first lane, masses and bodies of both sides) for kLanes manifolds at a time, and stores the bodies as it leaves
// them.
template <class Work>
HWY_INLINE void forManifolds(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities,
                             const Work &work) {
    dxVelocity elsewhere;
    for (unsigned i = begin; i < end; ++i) {
        const dxContactPack &pack = contacts.packs[i];
        for (unsigned first = 0; first < dxLanes::kCount; first += kLanes) {
            const Masses masses1 = Masses::load(pack, 0, first), masses2 = Masses::load(pack, 1, first);
            Bodies body1 = Bodies::load(pack, 0, first, velocities), body2 = Bodies::load(pack, 1, first, velocities);
            work(pack, first, masses1, masses2, body1, body2);
            body1.store(pack, 0, first, velocities, elsewhere);
            body2.store(pack, 1, first, velocities, elsewhere);
        }
    }
}

void apply(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities) {
    forManifolds(contacts, begin, end, velocities,
                 [&](const dxContactPack &pack, unsigned first, const Masses &masses1, const Masses &masses2, Bodies &body1,
                     Bodies &body2) HWY_ATTR {
                     for (unsigned k = 0; k < pack.contactCount; ++k) {
                         const dxContactLanes &contact = contacts.contacts[pack.firstContact + k];
                         const auto along = [&](unsigned row) HWY_ATTR {
                             return scale(loadVector(contact.direction[row], first), loadLanes(contact.impulse[row], first));
                         };
                         const Vector impulse = add(add(along(0), along(1)), along(2));
                         body1.push(masses1, loadVector(contact.arm[0], first), impulse);
                         body2.pull(masses2, loadVector(contact.arm[1], first), impulse);
                     }
                 });
}

// The normal first, then friction against its new impulse.
HWY_INLINE Lane relax(dxContactLanes &contact, unsigned first, const Masses &masses1, const Masses &masses2, Lane factor,
                      Bodies &body1, Bodies &body2) {
    const Vector arm1 = loadVector(contact.arm[0], first), arm2 = loadVector(contact.arm[1], first);
    const Vector normal = loadVector(contact.direction[0], first);
    const Vector tangent1 = loadVector(contact.direction[1], first), tangent2 = loadVector(contact.direction[2], first);
    const Vector relative = subtract(body1.velocityAt(arm1), body2.velocityAt(arm2));
    const auto residualOf = [&](int row, const Vector &direction, Lane impulse) {
        return hn::Sub(hn::Sub(loadLanes(contact.wanted[row], first), dot(direction, relative)),
                       hn::Mul(loadLanes(contact.softness[row], first), impulse));
    };
    const Lane old0 = loadLanes(contact.impulse[0], first);
    const Lane residual0 = residualOf(0, normal, old0);
    const Lane new0 =
        atLeast(hn::Zero(LaneTag()), hn::Add(old0, hn::Mul(factor, hn::Mul(residual0, loadLanes(contact.inverse[0], first)))));
    const Lane change0 = hn::Sub(new0, old0);
    storeLanes(new0, contact.impulse[0], first);

    const Lane old1 = loadLanes(contact.impulse[1], first), limit1 = limitOf(contact, 0, new0, first);
    const Lane residual1 = hn::Sub(residualOf(1, tangent1, old1), hn::Mul(loadLanes(contact.coupling[0], first), change0));
    const Lane wanted1 = hn::Add(old1, hn::Mul(factor, hn::Mul(residual1, loadLanes(contact.inverse[1], first))));
    const Lane new1 = clamp(limit1, wanted1);
    const Lane change1 = hn::Sub(new1, old1);
    storeLanes(new1, contact.impulse[1], first);

    const Lane old2 = loadLanes(contact.impulse[2], first), limit2 = limitOf(contact, 1, new0, first);
    const Lane coupled =
        hn::Add(hn::Mul(loadLanes(contact.coupling[1], first), change0), hn::Mul(loadLanes(contact.coupling[2], first), change1));
    const Lane residual2 = hn::Sub(residualOf(2, tangent2, old2), coupled);
    const Lane wanted2 = hn::Add(old2, hn::Mul(factor, hn::Mul(residual2, loadLanes(contact.inverse[2], first))));
    const Lane new2 = clamp(limit2, wanted2);
    const Lane change2 = hn::Sub(new2, old2);
    storeLanes(new2, contact.impulse[2], first);

    const Vector impulse = add(add(scale(normal, change0), scale(tangent1, change1)), scale(tangent2, change2));
    body1.push(masses1, arm1, impulse);
    body2.pull(masses2, arm2, impulse);
    return hn::Add(hn::Add(hn::Abs(hn::Mul(change0, residual0)), hn::Abs(hn::Mul(change1, residual1))),
                   hn::Abs(hn::Mul(change2, residual2)));
}

// A manifold's contacts are relaxed twice while its bodies are in registers: they depend on one another more than on others.
double sweep(const dxContactPacks &contacts, unsigned begin, unsigned end, dReal relaxation, dxVelocity *velocities) {
    const Lane factor = hn::Set(LaneTag(), relaxation);
    Energy energy;
    forManifolds(contacts, begin, end, velocities,
                 [&](const dxContactPack &pack, unsigned first, const Masses &masses1, const Masses &masses2, Bodies &body1,
                     Bodies &body2) HWY_ATTR {
                     dxContactLanes *const own = contacts.contacts + pack.firstContact;
                     if (pack.contactCount > 1)
                         for (unsigned k = 0; k < pack.contactCount; ++k)
                             relax(own[k], first, masses1, masses2, factor, body1, body2);
                     for (unsigned k = 0; k < pack.contactCount; ++k)
                         energy.add(relax(own[k], first, masses1, masses2, factor, body1, body2), first);
                 });
    return energy.sum();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxIterative
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxIterative {
HWY_EXPORT(prepare);
HWY_EXPORT(apply);
HWY_EXPORT(sweep);
}  // namespace dxIterative

double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(prepare)(contacts, begin, end, velocities);
}

void dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities) {
    using namespace dxIterative;
    HWY_DYNAMIC_DISPATCH(apply)(contacts, begin, end, velocities);
}

double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dReal factor, dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(sweep)(contacts, begin, end, factor, velocities);
}
#endif
