#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/quick_step/fast/dxContactSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "dynamics/quick_step/fast/dxContactLanes-inl.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"

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

// As forPacks, and stores the bodies as work leaves them.
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
    clearEnergies(contacts, begin, end);
    Energy energy(contacts);
    forMovingPacks(contacts, begin, end, 1, velocities,
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
                       energy.add(pack, hn::Add(sum, hn::Mul(hn::Set(LaneTag(), dReal(0.5)), work)), first);
                   });
    return energy.sum();
}

struct Factors {
    Lane pressure, friction;

    explicit HWY_INLINE Factors(const dxOverRelaxation &factor)
        : pressure(hn::Set(LaneTag(), factor.pressure)), friction(hn::Set(LaneTag(), factor.friction)) {}
};

// What a row lacks of what it asks for.
HWY_INLINE Lane residualOf(const dxContactLanes &contact, unsigned row, const Vector &relative, unsigned first) {
    const Lane yielding = hn::Mul(loadLanes(contact.softness[row], first), loadLanes(contact.impulse[row], first));
    return hn::Sub(hn::Sub(loadLanes(contact.wanted[row], first), yielding), dot(loadVector(contact.direction[row], first), relative));
}

// What does not wait for the residual is apart from what does: a contact takes as long as its longest chain of operations.
HWY_INLINE Lane moved(const dxContactLanes &contact, unsigned row, Lane residual, Lane factor, unsigned first) {
    const Lane step = hn::Mul(factor, loadLanes(contact.inverse[row], first));
    return hn::Add(loadLanes(contact.impulse[row], first), hn::Mul(residual, step));
}

struct Relaxed {
    Lane impulse, change, energy;

    static HWY_INLINE Relaxed to(Lane impulse, dxContactLanes &contact, unsigned row, Lane residual, unsigned first) {
        const Lane change = hn::Sub(impulse, loadLanes(contact.impulse[row], first));
        storeLanes(impulse, contact.impulse[row], first);
        return {impulse, change, hn::Abs(hn::Mul(change, residual))};
    }
};

HWY_INLINE Relaxed relaxNormal(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
    const Lane residual = residualOf(contact, 0, relative, first);
    const Lane impulse = atLeast(hn::Zero(LaneTag()), moved(contact, 0, residual, factor.pressure, first));
    return Relaxed::to(impulse, contact, 0, residual, first);
}

// pressure: the normal's impulse
HWY_INLINE Relaxed relaxTangent(dxContactLanes &contact, int tangent, unsigned first, const Factors &factor, Lane residual, Lane pressure) {
    const unsigned row = 1 + static_cast<unsigned>(tangent);
    const Lane impulse = clamp(limitOf(contact, tangent, pressure, first), moved(contact, row, residual, factor.friction, first));
    return Relaxed::to(impulse, contact, row, residual, first);
}

// The residual of a row after another one's change.
HWY_INLINE Lane coupled(Lane residual, const dxContactLanes &contact, unsigned coupling, Lane change, unsigned first) {
    return hn::Sub(residual, hn::Mul(loadLanes(contact.coupling[coupling], first), change));
}

// Of the impulses of some rows, and the energy of it.
template <unsigned kRows>
struct Change {
    Lane row[kRows], energy;
};

// Normals alone.
struct Pressure {
    static constexpr unsigned kFirstRow = 0, kRows = 1, kLeastContacts = 1;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
        const Relaxed normal = relaxNormal(contact, first, factor, relative);
        return {{normal.change}, normal.energy};
    }
};

// Both tangents.
struct Friction {
    static constexpr unsigned kFirstRow = 1, kRows = 2, kLeastContacts = 2;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
        const Lane pressure = loadLanes(contact.impulse[0], first), residual2 = residualOf(contact, 2, relative, first);
        const Relaxed a = relaxTangent(contact, 0, first, factor, residualOf(contact, 1, relative, first), pressure);
        const Relaxed b = relaxTangent(contact, 1, first, factor, coupled(residual2, contact, 2, a.change, first), pressure);
        return {{a.change, b.change}, hn::Add(a.energy, b.energy)};
    }
};

// The normal, then friction against its new impulse.
struct Contact {
    static constexpr unsigned kFirstRow = 0, kRows = 3, kLeastContacts = 1;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
        Lane residual1 = residualOf(contact, 1, relative, first), residual2 = residualOf(contact, 2, relative, first);
        const Relaxed normal = relaxNormal(contact, first, factor, relative);
        residual1 = coupled(residual1, contact, 0, normal.change, first);
        residual2 = coupled(residual2, contact, 1, normal.change, first);
        const Relaxed a = relaxTangent(contact, 0, first, factor, residual1, normal.impulse);
        const Relaxed b = relaxTangent(contact, 1, first, factor, coupled(residual2, contact, 2, a.change, first), normal.impulse);
        return {{normal.change, a.change, b.change}, hn::Add(hn::Add(normal.energy, a.energy), b.energy)};
    }
};

// Contacts begin, begin + step, ... of each manifold. More than one are relaxed so many times while the bodies are in registers, since
// contacts between the same bodies depend on one another more than on others.
struct Visit {
    unsigned begin, step, passes;
};

// What the last pass changes.
template <class Rows>
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, unsigned first, const Visit &visit, const Factors &factor,
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
                              const Visit &visit, const Factors &factor, Bodies &body1, Bodies &body2) {
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

// The same for the normals of all contacts: each one knows from the others' changes what it lacks.
template <>
HWY_INLINE Lane relaxManifold<Pressure>(const dxContactPack &pack, dxContactLanes *contacts, const dxContactResponse *responses,
                                        unsigned first, const Visit &visit, const Factors &factor, Bodies &body1, Bodies &body2) {
    const unsigned count = pack.contactCount;
    Lane residual[dxContactPack::kMaxContacts], pressure[dxContactPack::kMaxContacts], energy = hn::Zero(LaneTag());
    const RelativeMotion motion = RelativeMotion::of(body1, body2, loadVector(pack.between, first));
    for (unsigned k = 0; k < count; ++k) {
        residual[k] = residualOf(contacts[k], 0, motion.velocityAt(loadVector(contacts[k].arm, first)), first);
        pressure[k] = loadLanes(contacts[k].impulse[0], first);
    }
    for (unsigned pass = 0; pass < visit.passes; ++pass) {
        energy = hn::Zero(LaneTag());
        for (unsigned k = 0; k < count; ++k) {
            const Lane step = hn::Mul(factor.pressure, loadLanes(contacts[k].inverse[0], first));
            const Lane next = atLeast(hn::Zero(LaneTag()), hn::Add(pressure[k], hn::Mul(residual[k], step)));
            const Lane change = hn::Sub(next, pressure[k]);
            pressure[k] = next;
            energy = hn::Add(energy, hn::Abs(hn::Mul(change, residual[k])));
            for (unsigned i = 0; i < count; ++i)
                residual[i] = hn::Sub(residual[i], hn::Mul(loadFloats(responses[k].normal[i], first), change));
        }
    }
    Wrench wrench = Wrench::none();
    for (unsigned k = 0; k < count; ++k) {
        const Lane change[1] = {hn::Sub(pressure[k], loadLanes(contacts[k].impulse[0], first))};
        wrench.add(contacts[k], change, 0, first);
        storeLanes(pressure[k], contacts[k].impulse[0], first);
    }
    wrench.actOn(pack, first, body1, body2);
    return energy;
}

// A single contact has pressure and friction in the first part: it depends on no others of its manifold.
template <class Rows>
HWY_INLINE double relaxPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, const Visit &visit,
                             const dxOverRelaxation &relaxation, dxVelocity *velocities) {
    const Factors factor(relaxation);
    Energy energy(contacts);
    forMovingPacks(contacts, begin, end, Rows::kLeastContacts, velocities,
                   [&](const dxContactPack &pack, unsigned first, Bodies &body1, Bodies &body2) HWY_ATTR {
                       dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       const dxContactResponse *const responses = responsesOf(contacts, pack);
                       Lane found;
                       if (pack.contactCount == 1)
                           found = relaxManifold<Contact>(pack, own, first, {0, 1, 1}, factor, body1, body2);
                       else if (responses != nullptr)
                           found = relaxManifold<Rows>(pack, own, responses, first, visit, factor, body1, body2);
                       else
                           found = relaxManifold<Rows>(pack, own, first, visit, factor, body1, body2);
                       energy.add(pack, found, first);
                   });
    return energy.sum();
}

double sweep(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, const dxOverRelaxation &factor,
             dxVelocity *velocities) {
    if (dxIsFirst(part)) clearEnergies(contacts, begin, end);
    switch (part) {
    case dxSweepPart::Contacts: return relaxPacks<Contact>(contacts, begin, end, {0, 1, 2}, factor, velocities);
    case dxSweepPart::Pressures: return relaxPacks<Pressure>(contacts, begin, end, {0, 1, 2}, factor, velocities);
    case dxSweepPart::EvenFriction: return relaxPacks<Friction>(contacts, begin, end, {0, 2, 1}, factor, velocities);
    default: return relaxPacks<Friction>(contacts, begin, end, {1, 2, 1}, factor, velocities);
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

double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, const dxOverRelaxation &factor,
                       dxVelocity *velocities) {
    using namespace dxIterative;
    return HWY_DYNAMIC_DISPATCH(sweep)(contacts, begin, end, part, factor, velocities);
}
#endif
