#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/quick_step/fast/dxContactPreparation.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <limits>

#include "dynamics/quick_step/fast/dxContactLanes-inl.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxIterative {
namespace HWY_NAMESPACE {

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

// What one of the bodies adds to the matrix J inv(M) J' of a contact's rows.
struct Turns {
    Vector axis[3], turned[3];  // arm x direction, and that times the inverse inertia

    static HWY_INLINE Turns of(const Masses &masses, const Vector &arm, const Vector (&direction)[3]) {
        Turns turns;
        for (int i = 0; i < 3; ++i) {
            turns.axis[i] = cross(arm, direction[i]);
            turns.turned[i] = masses.turn(turns.axis[i]);
        }
        return turns;
    }
};

// Sets the directions to normal and tangents.
HWY_INLINE void findDirections(dxContactLanes &contact, unsigned first, Vector (&direction)[3]) {
    const Vector normal = loadVector(contact.direction[0], first), given = loadVector(contact.direction[1], first);
    const auto isGiven = hn::Gt(hn::Add(hn::Add(hn::Abs(given.x), hn::Abs(given.y)), hn::Abs(given.z)), hn::Zero(LaneTag()));
    const Vector found = tangentOf(normal);
    direction[0] = normal;
    direction[1] = {hn::IfThenElse(isGiven, given.x, found.x), hn::IfThenElse(isGiven, given.y, found.y),
                    hn::IfThenElse(isGiven, given.z, found.z)};
    direction[2] = cross(normal, direction[1]);
    for (int i = 0; i < 3; ++i) storeVector(direction[i], contact.direction[i], first);
}

// The kept force, along the directions and within the limits.
HWY_INLINE void projectImpulse(dxContactLanes &contact, unsigned first, const Vector (&direction)[3]) {
    const Vector force = loadVector(contact.impulse, first);
    const Lane pressure = atLeast(hn::Zero(LaneTag()), dot(force, direction[0]));
    storeLanes(pressure, contact.impulse[0], first);
    for (int i = 1; i < 3; ++i)
        storeLanes(clamp(limitOf(contact, i - 1, pressure, first), dot(force, direction[i])), contact.impulse[i], first);
}

// The nearest floats; the largest one for numbers beyond it.
template <class Tag = LaneTag>
HWY_INLINE void storeFloats(Lane numbers, dxContactResponse::Numbers &floats, unsigned first) {
    if constexpr (sizeof(hn::TFromD<Tag>) == sizeof(float)) {
        hn::Store(numbers, Tag(), floats.lane + first);
    } else {
        const Lane largest = hn::Set(Tag(), std::numeric_limits<float>::max());
        hn::Store(hn::DemoteTo(FloatTag<Tag>(), clamp(largest, numbers)), FloatTag<Tag>(), floats.lane + first);
    }
}

// response: of the contact, or none
HWY_INLINE Lane prepareContact(const dxContactPack &pack, dxContactLanes &contact, dxContactResponse *response, unsigned first,
                               const Bodies &body1, const Bodies &body2) {
    const Masses masses1 = Masses::load(pack, 0, first), masses2 = Masses::load(pack, 1, first);
    const Vector between = loadVector(pack.between, first), arm = loadVector(contact.arm, first);
    Vector direction[3];
    findDirections(contact, first, direction);
    projectImpulse(contact, first, direction);
    const Turns turns1 = Turns::of(masses1, arm, direction), turns2 = Turns::of(masses2, add(arm, between), direction);
    const Lane inverseMass = hn::Add(masses1.inverse, masses2.inverse);
    const auto couple = [&](int i, int k) HWY_ATTR {
        return hn::Add(hn::Mul(inverseMass, dot(direction[i], direction[k])),
                       hn::Add(dot(turns1.axis[i], turns1.turned[k]), dot(turns2.axis[i], turns2.turned[k])));
    };
    storeLanes(couple(0, 1), contact.coupling[0], first);
    storeLanes(couple(0, 2), contact.coupling[1], first);
    storeLanes(couple(1, 2), contact.coupling[2], first);
    for (int i = 0; i < 3; ++i) {
        storeLanes(inverseOf(hn::Add(couple(i, i), loadLanes(contact.softness[i], first))), contact.inverse[i], first);
        if (response == nullptr) continue;
        const Vector v = add(scale(direction[i], inverseMass), cross(turns2.turned[i], between));
        const Vector w = add(turns1.turned[i], turns2.turned[i]);
        const Lane motion[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
        for (int k = 0; k < 6; ++k) storeFloats(motion[k], response->row[i][k], first);
    }
    const Lane relative = dot(direction[0], RelativeMotion::of(body1, body2, between).velocityAt(arm));
    const Lane residual = atLeast(hn::Zero(LaneTag()), hn::Sub(loadLanes(contact.wanted[0], first), relative));
    return hn::Mul(hn::Mul(residual, residual), loadLanes(contact.inverse[0], first));
}

// Of what an impulse along the normal changes, from the responses of the bodies' motion.
HWY_INLINE void findNormalResponses(const dxContactPack &pack, const dxContactLanes *contacts, unsigned first,
                                    dxContactResponse *responses) {
    for (unsigned k = 0; k < pack.contactCount; ++k) {
        const Vector normal = loadVector(contacts[k].direction[0], first), arm = loadVector(contacts[k].arm, first);
        for (unsigned i = 0; i < pack.contactCount; ++i) {
            Lane change = dot(normal, RelativeMotion::of(responses[i].row[0], first).velocityAt(arm));
            if (i == k) change = hn::Add(change, loadLanes(contacts[k].softness[0], first));
            storeFloats(change, responses[i].normal[k], first);
        }
    }
}

double prepare(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities) {
    clearEnergies(contacts, begin, end);
    Energy energy(contacts);
    forPacks(contacts, begin, end, 1, velocities,
             [&](const dxContactPack &pack, unsigned first, const Bodies &body1, const Bodies &body2) HWY_ATTR {
                 dxContactLanes *const own = contacts.contacts + pack.firstContact;
                 dxContactResponse *const responses = responsesOf(contacts, pack);
                 Lane sum = hn::Zero(LaneTag());
                 for (unsigned k = 0; k < pack.contactCount; ++k) {
                     dxContactResponse *const response = responses != nullptr ? responses + k : nullptr;
                     sum = hn::Add(sum, prepareContact(pack, own[k], response, first, body1, body2));
                 }
                 if (responses != nullptr) findNormalResponses(pack, own, first, responses);
                 energy.add(pack, sum, first);
             });
    return energy.sum();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxIterative
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxIterative {
HWY_EXPORT(prepare);
}  // namespace dxIterative

double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(prepare)(contacts, begin, end, velocities);
}
#endif
