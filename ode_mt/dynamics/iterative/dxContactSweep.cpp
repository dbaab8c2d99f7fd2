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

    // impulses: along the contact's directions from firstRow on
    template <unsigned kCount>
    HWY_INLINE void add(const dxContactLanes &contact, const Lane (&impulses)[kCount], unsigned firstRow, unsigned first) {
        Vector sum = scale(loadVector(contact.direction[firstRow], first), impulses[0]);
        for (unsigned i = 1; i < kCount; ++i)
            sum = HWY_NAMESPACE::add(sum, scale(loadVector(contact.direction[firstRow + i], first), impulses[i]));
        impulse = HWY_NAMESPACE::add(impulse, sum);
        turning = HWY_NAMESPACE::add(turning, cross(loadVector(contact.arm, first), sum));
    }

    HWY_INLINE void actOn(const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) const {
        body1.push(Masses::load(pack, 0, first), impulse, turning);
        body2.pull(Masses::load(pack, 1, first), impulse,
                   HWY_NAMESPACE::add(turning, cross(loadVector(pack.between, first), impulse)));
    }
};

// As forPacks, for packs with more than so many contacts, and stores the bodies as work leaves them.
template <class Work>
HWY_INLINE void forMovingPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, unsigned least, dxVelocity *velocities,
                               const Work &work) {
    dxVelocity elsewhere;
    forPacks(contacts, begin, end, least, velocities,
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
    forMovingPacks(contacts, begin, end, 0, velocities,
                   [&](const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) HWY_ATTR {
                       const dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       Wrench wrench = Wrench::none();
                       Lane sum = hn::Zero(LaneTag());
                       for (unsigned k = 0; k < pack.contactCount; ++k) {
                           const Lane impulses[] = {loadLanes(own[k].impulse[0], first), loadLanes(own[k].impulse[1], first),
                                                    loadLanes(own[k].impulse[2], first)};
                           wrench.add(own[k], impulses, 0, first);
                           sum = hn::Add(sum, energyOf(own[k], first));
                       }
                       const Vector between = loadVector(pack.between, first);
                       const RelativeMotion before = RelativeMotion::of(body1, body2, between);
                       wrench.actOn(pack, first, body1, body2);
                       const RelativeMotion twice = RelativeMotion::of(body1, body2, between).plus(before);
                       const Lane work = hn::Add(dot(wrench.impulse, twice.v), dot(wrench.turning, twice.w));
                       energy.set(pack, hn::Add(sum, hn::Mul(hn::Set(LaneTag(), dReal(0.5)), work)), first);
                   });
    return energy.sum();
}

template <unsigned kRows>
struct Change {
    Lane row[kRows], energy;
};

// What a row lacks of what it asks for.
HWY_INLINE Lane residualOf(const dxContactLanes &contact, unsigned row, Lane impulse, const Vector &relative, unsigned first) {
    const Lane wanted = hn::Sub(loadLanes(contact.wanted[row], first), hn::Mul(loadLanes(contact.softness[row], first), impulse));
    return hn::Sub(wanted, dot(loadVector(contact.direction[row], first), relative));
}

// What is not known before the residual is a single addition and product: a contact takes as long as its longest chain of operations.
HWY_INLINE Lane moved(const dxContactLanes &contact, unsigned row, Lane impulse, Lane residual, Lane factor, unsigned first) {
    return hn::Add(impulse, hn::Mul(residual, hn::Mul(factor, loadLanes(contact.inverse[row], first))));
}

struct Pressure {
    static constexpr unsigned kFirstRow = 0, kRows = 1;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, Lane factor, const Vector &relative) {
        const Lane old = loadLanes(contact.impulse[0], first), residual = residualOf(contact, 0, old, relative, first);
        const Lane pressure = atLeast(hn::Zero(LaneTag()), moved(contact, 0, old, residual, factor, first));
        storeLanes(pressure, contact.impulse[0], first);
        const Lane change = hn::Sub(pressure, old);
        return {{change}, hn::Abs(hn::Mul(change, residual))};
    }
};

struct Friction {
    static constexpr unsigned kFirstRow = 1, kRows = 2;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, Lane factor, const Vector &relative) {
        const Lane pressure = loadLanes(contact.impulse[0], first);
        Change<kRows> change = {{}, hn::Zero(LaneTag())};
        for (unsigned i = 0; i < kRows; ++i) {
            const Lane old = loadLanes(contact.impulse[1 + i], first);
            Lane residual = residualOf(contact, 1 + i, old, relative, first);
            if (i == 1) residual = hn::Sub(residual, hn::Mul(loadLanes(contact.coupling, first), change.row[0]));
            const Lane friction =
                clamp(limitOf(contact, static_cast<int>(i), pressure, first), moved(contact, 1 + i, old, residual, factor, first));
            storeLanes(friction, contact.impulse[1 + i], first);
            change.row[i] = hn::Sub(friction, old);
            change.energy = hn::Add(change.energy, hn::Abs(hn::Mul(change.row[i], residual)));
        }
        return change;
    }
};

// Contacts begin, begin + step, ... of each manifold, so many times in turn while the bodies are in registers.
struct Visit {
    unsigned begin, step, passes;
};

// What the last pass changes.
template <class Rows>
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, unsigned first, const Visit &visit, Lane factor,
                              Bodies &body1, Bodies &body2) {
    const Vector between = loadVector(pack.between, first);
    Lane energy = hn::Zero(LaneTag());
    for (unsigned pass = 0; pass < visit.passes; ++pass) {
        energy = hn::Zero(LaneTag());
        for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step) {
            const RelativeMotion motion = RelativeMotion::of(body1, body2, between);
            const auto change = Rows::relax(contacts[k], first, factor, motion.velocityAt(loadVector(contacts[k].arm, first)));
            Wrench wrench = Wrench::none();
            wrench.add(contacts[k], change.row, Rows::kFirstRow, first);
            wrench.actOn(pack, first, body1, body2);
            energy = hn::Add(energy, change.energy);
        }
    }
    return energy;
}

// The same, but that the bodies move when the last contact is done. Until then their relative motion tells all.
template <class Rows>
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, const dxContactResponse *responses, unsigned first,
                              const Visit &visit, Lane factor, Bodies &body1, Bodies &body2) {
    const LaneTag d;
    HWY_ALIGN dReal before[dxContactPack::kMaxContacts][Rows::kRows][dxLanes::kCount];
    for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step)
        for (unsigned i = 0; i < Rows::kRows; ++i)
            hn::Store(loadLanes(contacts[k].impulse[Rows::kFirstRow + i], first), d, before[k][i]);
    RelativeMotion motion = RelativeMotion::of(body1, body2, loadVector(pack.between, first));
    Lane energy = hn::Zero(d);
    for (unsigned pass = 0; pass < visit.passes; ++pass) {
        energy = hn::Zero(d);
        for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step) {
            const auto change = Rows::relax(contacts[k], first, factor, motion.velocityAt(loadVector(contacts[k].arm, first)));
            for (unsigned i = 0; i < Rows::kRows; ++i) motion.respond(responses[k].row[Rows::kFirstRow + i], change.row[i], first);
            energy = hn::Add(energy, change.energy);
        }
    }
    Wrench wrench = Wrench::none();
    for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step) {
        Lane changes[Rows::kRows];
        for (unsigned i = 0; i < Rows::kRows; ++i)
            changes[i] = hn::Sub(loadLanes(contacts[k].impulse[Rows::kFirstRow + i], first), hn::Load(d, before[k][i]));
        wrench.add(contacts[k], changes, Rows::kFirstRow, first);
    }
    wrench.actOn(pack, first, body1, body2);
    return energy;
}

template <class Rows>
HWY_INLINE double relaxPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, const Visit &visit, dReal overRelaxation,
                             dxVelocity *velocities) {
    const Lane factor = hn::Set(LaneTag(), overRelaxation);
    Energy energy(contacts);
    forMovingPacks(contacts, begin, end, visit.begin, velocities,
                   [&](const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) HWY_ATTR {
                       dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       const dxContactResponse *const responses = responsesOf(contacts, pack);
                       const Visit turns = {visit.begin, visit.step, pack.contactCount > 1 ? visit.passes : 1};
                       const Lane found = responses != nullptr
                                              ? relaxManifold<Rows>(pack, own, responses, first, turns, factor, body1, body2)
                                              : relaxManifold<Rows>(pack, own, first, turns, factor, body1, body2);
                       if (Rows::kFirstRow == 0)
                           energy.set(pack, found, first);
                       else
                           energy.add(pack, found, first);
                   });
    return energy.sum();
}

double sweep(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, dReal overRelaxation,
             dxVelocity *velocities) {
    switch (part) {
    case dxSweepPart::Pressures: return relaxPacks<Pressure>(contacts, begin, end, {0, 1, 2}, overRelaxation, velocities);
    case dxSweepPart::EvenFriction: return relaxPacks<Friction>(contacts, begin, end, {0, 2, 1}, overRelaxation, velocities);
    default: return relaxPacks<Friction>(contacts, begin, end, {1, 2, 1}, overRelaxation, velocities);
    }
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

double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, dReal overRelaxation,
                       dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(sweep)(contacts, begin, end, part, overRelaxation, velocities);
}
#endif
