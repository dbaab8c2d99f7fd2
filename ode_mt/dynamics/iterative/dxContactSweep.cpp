#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/iterative/dxContactSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "dynamics/iterative/dxContactLanes-inl.h"
#include "dynamics/iterative/dxContactSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxIterative {
namespace HWY_NAMESPACE {

// The impulses of some contacts between the same bodies, as one in the first body's centre.
struct Wrench {
    Vector impulse, turning;

    static HWY_INLINE Wrench none() {
        const Lane zero = hn::Zero(LaneTag());
        return {{zero, zero, zero}, {zero, zero, zero}};
    }

    // impulses: along the contact's three directions
    HWY_INLINE void add(const dxContactLanes &contact, const Vector &impulses, unsigned first) {
        const auto along = [&](unsigned row, Lane part) HWY_ATTR { return scale(loadVector(contact.direction[row], first), part); };
        const Vector sum = HWY_NAMESPACE::add(HWY_NAMESPACE::add(along(0, impulses.x), along(1, impulses.y)), along(2, impulses.z));
        impulse = HWY_NAMESPACE::add(impulse, sum);
        turning = HWY_NAMESPACE::add(turning, cross(loadVector(contact.arm, first), sum));
    }

    HWY_INLINE void actOn(const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) const {
        body1.push(Masses::load(pack, 0, first), impulse, turning);
        body2.pull(Masses::load(pack, 1, first), impulse,
                   HWY_NAMESPACE::add(turning, cross(loadVector(pack.between, first), impulse)));
    }
};

// As forPacks, and stores the bodies as work leaves them.
template <class Work>
HWY_INLINE void forMovingPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities,
                               const Work &work) {
    dxVelocity elsewhere;
    forPacks(contacts, begin, end, velocities,
             [&](const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) HWY_ATTR {
                 work(pack, first, body1, body2);
                 body1.store(pack, 0, first, velocities, elsewhere);
                 body2.store(pack, 1, first, velocities, elsewhere);
             });
}

// 1/2 p' softness p - wanted' p
HWY_INLINE Lane energyOf(const dxContactLanes &contact, unsigned first) {
    const Lane half = hn::Set(LaneTag(), dReal(0.5));
    Lane energy = hn::Zero(LaneTag());
    for (unsigned row = 0; row < dxContactLanes::kRows; ++row) {
        const Lane impulse = loadLanes(contact.impulse[row], first);
        const Lane yielding = hn::Mul(half, hn::Mul(loadLanes(contact.softness[row], first), impulse));
        energy = hn::Add(energy, hn::Mul(impulse, hn::Sub(yielding, loadLanes(contact.wanted[row], first))));
    }
    return energy;
}

// The kinetic energy changes by the wrench's work on the mean of the motions before and after it.
double apply(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities) {
    Energy energy(contacts);
    forMovingPacks(contacts, begin, end, velocities,
                   [&](const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) HWY_ATTR {
                       const dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       Wrench wrench = Wrench::none();
                       Lane sum = hn::Zero(LaneTag());
                       for (unsigned k = 0; k < pack.contactCount; ++k) {
                           wrench.add(own[k], loadVector(own[k].impulse, first), first);
                           sum = hn::Add(sum, energyOf(own[k], first));
                       }
                       const Vector between = loadVector(pack.between, first);
                       const RelativeMotion before = RelativeMotion::of(body1, body2, between);
                       wrench.actOn(pack, first, body1, body2);
                       const RelativeMotion twice = RelativeMotion::of(body1, body2, between).plus(before);
                       const Lane work = hn::Add(dot(wrench.impulse, twice.v), dot(wrench.turning, twice.w));
                       energy.add(pack, hn::Add(sum, hn::Mul(hn::Set(LaneTag(), dReal(0.5)), work)), first);
                   });
    return energy.sum();
}

struct Factors {
    Lane row[dxContactLanes::kRows];

    explicit HWY_INLINE Factors(const dxOverRelaxation &factor) {
        row[0] = hn::Set(LaneTag(), factor.pressure);
        row[1] = row[2] = hn::Set(LaneTag(), factor.friction);
    }
};

struct Change {
    Lane row[dxContactLanes::kRows], energy;
};

// The normal first, then friction against its new impulse. What does not wait for the motion or for an earlier row is apart from
// what does: a contact takes as long as its longest chain of operations.
HWY_INLINE Change relax(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
    Lane old[3], residual[3], step[3];
    for (unsigned row = 0; row < 3; ++row) {
        old[row] = loadLanes(contact.impulse[row], first);
        const Lane wanted =
            hn::Sub(loadLanes(contact.wanted[row], first), hn::Mul(loadLanes(contact.softness[row], first), old[row]));
        residual[row] = hn::Sub(wanted, dot(loadVector(contact.direction[row], first), relative));
        step[row] = hn::Mul(factor.row[row], loadLanes(contact.inverse[row], first));
    }
    const auto coupled = [&](Lane value, unsigned coupling, Lane change) HWY_ATTR {
        return hn::Sub(value, hn::Mul(loadLanes(contact.coupling[coupling], first), change));
    };
    const auto moved = [&](unsigned row) HWY_ATTR { return hn::Add(old[row], hn::Mul(residual[row], step[row])); };
    Change change;
    const Lane pressure = atLeast(hn::Zero(LaneTag()), moved(0));
    storeLanes(pressure, contact.impulse[0], first);
    change.row[0] = hn::Sub(pressure, old[0]);

    residual[1] = coupled(residual[1], 0, change.row[0]);
    residual[2] = coupled(residual[2], 1, change.row[0]);
    const Lane friction1 = clamp(limitOf(contact, 0, pressure, first), moved(1));
    storeLanes(friction1, contact.impulse[1], first);
    change.row[1] = hn::Sub(friction1, old[1]);

    residual[2] = coupled(residual[2], 2, change.row[1]);
    const Lane friction2 = clamp(limitOf(contact, 1, pressure, first), moved(2));
    storeLanes(friction2, contact.impulse[2], first);
    change.row[2] = hn::Sub(friction2, old[2]);

    const auto energyOf = [&](unsigned row) HWY_ATTR { return hn::Abs(hn::Mul(change.row[row], residual[row])); };
    change.energy = hn::Add(hn::Add(energyOf(0), energyOf(1)), energyOf(2));
    return change;
}

HWY_INLINE Lane relaxBodies(const dxContactPack &pack, dxContactLanes &contact, unsigned first, const Factors &factor, Bodies &body1,
                            Bodies &body2) {
    const RelativeMotion motion = RelativeMotion::of(body1, body2, loadVector(pack.between, first));
    const Change change = relax(contact, first, factor, motion.velocityAt(loadVector(contact.arm, first)));
    Wrench wrench = Wrench::none();
    wrench.add(contact, {change.row[0], change.row[1], change.row[2]}, first);
    wrench.actOn(pack, first, body1, body2);
    return change.energy;
}

// Twice, while the bodies are in registers: contacts between the same bodies depend on one another more than on others.
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, unsigned first, const Factors &factor, Bodies &body1,
                              Bodies &body2) {
    if (pack.contactCount > 1)
        for (unsigned k = 0; k < pack.contactCount; ++k) relaxBodies(pack, contacts[k], first, factor, body1, body2);
    Lane energy = hn::Zero(LaneTag());
    for (unsigned k = 0; k < pack.contactCount; ++k)
        energy = hn::Add(energy, relaxBodies(pack, contacts[k], first, factor, body1, body2));
    return energy;
}

// The same, but that the bodies move when the last contact is done. Until then their relative motion tells all.
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, const dxContactResponse *responses,
                              unsigned first, const Factors &factor, Bodies &body1, Bodies &body2) {
    const LaneTag d;
    HWY_ALIGN dReal before[dxContactPack::kMaxContacts][3][dxLanes::kCount];
    RelativeMotion motion = RelativeMotion::of(body1, body2, loadVector(pack.between, first));
    const auto relaxOne = [&](unsigned k) HWY_ATTR {
        const Change change = relax(contacts[k], first, factor, motion.velocityAt(loadVector(contacts[k].arm, first)));
        for (unsigned row = 0; row < 3; ++row) motion.respond(responses[k].row[row], change.row[row], first);
        return change.energy;
    };
    for (unsigned k = 0; k < pack.contactCount; ++k) {
        for (unsigned row = 0; row < 3; ++row) hn::Store(loadLanes(contacts[k].impulse[row], first), d, before[k][row]);
        relaxOne(k);
    }
    Lane energy = hn::Zero(d);
    Wrench wrench = Wrench::none();
    for (unsigned k = 0; k < pack.contactCount; ++k) {
        energy = hn::Add(energy, relaxOne(k));
        const Vector old = {hn::Load(d, before[k][0]), hn::Load(d, before[k][1]), hn::Load(d, before[k][2])};
        wrench.add(contacts[k], subtract(loadVector(contacts[k].impulse, first), old), first);
    }
    wrench.actOn(pack, first, body1, body2);
    return energy;
}

double sweep(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxOverRelaxation &relaxation,
             dxVelocity *velocities) {
    const Factors factor(relaxation);
    Energy energy(contacts);
    forMovingPacks(contacts, begin, end, velocities,
                   [&](const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) HWY_ATTR {
                       dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       const dxContactResponse *const responses = responsesOf(contacts, pack);
                       energy.add(pack,
                                  responses != nullptr ? relaxManifold(pack, own, responses, first, factor, body1, body2)
                                                       : relaxManifold(pack, own, first, factor, body1, body2),
                                  first);
                   });
    return energy.sum();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxIterative
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxIterative {
HWY_EXPORT(apply);
HWY_EXPORT(sweep);
}  // namespace dxIterative

double dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(apply)(contacts, begin, end, velocities);
}

double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxOverRelaxation &factor,
                       dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(sweep)(contacts, begin, end, factor, velocities);
}
#endif
