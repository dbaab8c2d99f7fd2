#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/quick_step/fast/dxContactPreparation.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "core/dxFlushSubnormals.h"
#include "dynamics/quick_step/fast/dxContactLanes-inl.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxContactKernels {
namespace HWY_NAMESPACE {

// Returns a tangent of a normal of length 1, as upstream's dPlaneSpace chooses it: horizontal, unless the normal is nearly horizontal.
HWY_INLINE Vector tangentOf(const Vector &normal) {
    const LaneTag d;
    const Lane none = hn::Zero(d);
    const auto isSteep = hn::Gt(hn::Abs(normal.z), hn::Set(d, 0.70710678118654752440f));
    const Lane a = hn::IfThenElse(isSteep, normal.y, normal.x), b = hn::IfThenElse(isSteep, normal.z, normal.y);
    const Lane square = hn::Add(hn::Mul(a, a), hn::Mul(b, b));
    const Lane inverse = inverseOf(hn::Sqrt(square));
    const Lane first = hn::Mul(hn::Neg(b), inverse), second = hn::Mul(a, inverse);
    return {hn::IfThenElse(isSteep, none, first), hn::IfThenElse(isSteep, first, second), hn::IfThenElse(isSteep, second, none)};
}

// What body A (or B) adds to the matrix J inv(M) J' of a contact's rows.
struct AngularTerms {
    Vector axis[3], turned[3];  // rA x direction, and that times the inverse inertia

    static HWY_INLINE AngularTerms of(const Masses &masses, const Vector &rA, const Vector (&direction)[3]) {
        AngularTerms terms;
        for (int i = 0; i < 3; ++i) {
            terms.axis[i] = cross(rA, direction[i]);
            terms.turned[i] = masses.turn(terms.axis[i]);
        }
        return terms;
    }
};

// Sets the directions to the normal and two tangents.
HWY_INLINE void findDirections(dxContactLanes &contact, unsigned first, Vector (&direction)[3]) {
    const Vector normal = loadVector(contact.direction[kNormal], first), given = loadVector(contact.direction[kTangent], first);
    const auto isGiven = hn::Gt(hn::Add(hn::Add(hn::Abs(given.x), hn::Abs(given.y)), hn::Abs(given.z)), hn::Zero(LaneTag()));
    const Vector found = tangentOf(normal);
    direction[0] = normal;
    direction[1] = {hn::IfThenElse(isGiven, given.x, found.x), hn::IfThenElse(isGiven, given.y, found.y),
                    hn::IfThenElse(isGiven, given.z, found.z)};
    direction[2] = cross(normal, direction[1]);
    for (int i = 0; i < 3; ++i) storeVector(direction[i], contact.direction[i], first);
}

// Projects the kept impulse, a vector of the world, on the directions and into the limits.
HWY_INLINE void projectImpulse(dxContactLanes &contact, unsigned first, const Vector (&direction)[3]) {
    const Vector force = loadVector(contact.impulse, first);
    const Lane normalImpulse = atLeast(hn::Zero(LaneTag()), dot(force, direction[0]));
    storeLanes(normalImpulse, contact.impulse[kNormal], first);
    for (int i = 1; i < 3; ++i)
        storeLanes(clamp(limitOf(contact, i - 1, normalImpulse, first), dot(force, direction[i])), contact.impulse[i], first);
}

// `response`: of the contact; null: none. Returns the energy of the residual of the normal without impulses.
HWY_INLINE Lane prepareContact(const dxContactPack &pack, dxContactLanes &contact, dxContactResponse *response, unsigned first,
                               const RelativeMotion &motion) {
    const Masses massesA = Masses::load(pack, 0, first), massesB = Masses::load(pack, 1, first);
    const Vector dAB = loadVector(pack.dAB, first), rA = loadVector(contact.rA, first);
    Vector direction[3];
    findDirections(contact, first, direction);
    projectImpulse(contact, first, direction);
    const AngularTerms angularA = AngularTerms::of(massesA, rA, direction), angularB = AngularTerms::of(massesB, add(rA, dAB), direction);
    const Lane inverseMass = hn::Add(massesA.invMass, massesB.invMass);
    const auto couple = [&](int i, int k) HWY_ATTR {
        return hn::Add(hn::Mul(inverseMass, dot(direction[i], direction[k])),
                       hn::Add(dot(angularA.axis[i], angularA.turned[k]), dot(angularB.axis[i], angularB.turned[k])));
    };
    storeLanes(couple(0, 1), contact.coupling[0], first);
    storeLanes(couple(0, 2), contact.coupling[1], first);
    storeLanes(couple(1, 2), contact.coupling[2], first);
    for (int i = 0; i < 3; ++i) {
        storeLanes(inverseOf(hn::Add(couple(i, i), loadLanes(contact.softness[i], first))), contact.effectiveMass[i], first);
        if (response == nullptr) continue;
        const Vector v = add(scale(direction[i], inverseMass), cross(angularB.turned[i], dAB));
        const Vector w = add(angularA.turned[i], angularB.turned[i]);
        const Lane motion[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
        for (int k = 0; k < 6; ++k) storeLanes(motion[k], response->row[i][k], first);
    }
    const Lane relative = dot(direction[kNormal], motion.velocityAt(rA));
    const Lane residual = atLeast(hn::Zero(LaneTag()), hn::Sub(loadLanes(contact.bias[kNormal], first), relative));
    return hn::Mul(hn::Mul(residual, residual), loadLanes(contact.effectiveMass[kNormal], first));
}

// Finds how an impulse along each normal changes the residuals of all normals, from the responses of the bodies' motion.
HWY_INLINE void findNormalResponses(const dxContactPack &pack, const dxContactLanes *contacts, unsigned first,
                                    dxContactResponse *responses) {
    for (unsigned k = 0; k < pack.contactCount; ++k) {
        const Vector normal = loadVector(contacts[k].direction[kNormal], first), rA = loadVector(contacts[k].rA, first);
        for (unsigned i = 0; i < pack.contactCount; ++i) {
            Lane change = dot(normal, RelativeMotion::of(responses[i].row[kNormal], first).velocityAt(rA));
            if (i == k) change = hn::Add(change, loadLanes(contacts[k].softness[kNormal], first));
            storeLanes(change, responses[i].normal[k], first);
        }
    }
}

double prepare(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxSpatialMotion *velocities) {
    clearEnergies(contacts.energies, begin, end);
    Energy energy(contacts.energies);
    forPacks(contacts, begin, end, 1, velocities,
             [&](const dxContactPack &pack, unsigned first, const RelativeMotion &motion) HWY_ATTR {
                 dxContactLanes *const own = contacts.contacts + pack.firstContact;
                 dxContactResponse *const responses = responsesOf(contacts, pack);
                 Lane sum = hn::Zero(LaneTag());
                 for (unsigned k = 0; k < pack.contactCount; ++k) {
                     dxContactResponse *const response = responses != nullptr ? responses + k : nullptr;
                     sum = hn::Add(sum, prepareContact(pack, own[k], response, first, motion));
                 }
                 if (responses != nullptr) findNormalResponses(pack, own, first, responses);
                 energy.add(std::size_t(&pack - contacts.packs), sum, first);
             });
    return energy.sum();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxContactKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxContactKernels {
HWY_EXPORT(prepare);
}  // namespace dxContactKernels

double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxSpatialMotion *velocities) {
    using namespace dxContactKernels;
    const dxFlushSubnormals flush;
    return HWY_DYNAMIC_DISPATCH(prepare)(contacts, begin, end, velocities);
}
#endif
