#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/quick_step/fast/dxContactSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "core/dxFlushSubnormals.h"
#include "dynamics/quick_step/fast/dxContactLanes-inl.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxContactKernels {
namespace HWY_NAMESPACE {

// The impulses of some contacts between the same bodies as one linear and one angular impulse in the centre of A.
template <class Tag>
struct WrenchOf {
    using Number = hn::Vec<Tag>;

    VectorOf<Number> impulse, turning;

    static HWY_INLINE WrenchOf none() {
        const Number zero = hn::Zero(Tag());
        return {{zero, zero, zero}, {zero, zero, zero}};
    }

    // `impulses`: along the contact's directions, from firstRow on
    template <unsigned kCount>
    HWY_INLINE void add(const dxContactLanes &contact, const Number (&impulses)[kCount], unsigned firstRow, unsigned first) {
        VectorOf<Number> sum = scale(loadVector<Tag>(contact.direction[firstRow], first), impulses[0]);
        for (unsigned i = 1; i < kCount; ++i)
            sum = HWY_NAMESPACE::add(sum, scale(loadVector<Tag>(contact.direction[firstRow + i], first), impulses[i]));
        impulse = HWY_NAMESPACE::add(impulse, sum);
        turning = HWY_NAMESPACE::add(turning, cross(loadVector<Tag>(contact.rA, first), sum));
    }

    HWY_INLINE void addAll(const dxContactLanes &contact, unsigned first) {
        const Number impulses[] = {loadLanes<Tag>(contact.impulse[0], first), loadLanes<Tag>(contact.impulse[1], first),
                                   loadLanes<Tag>(contact.impulse[2], first)};
        add(contact, impulses, 0, first);
    }

    // Returns the angular impulse in the centre of B.
    HWY_INLINE VectorOf<Number> turningOfB(const dxContactPack &pack, unsigned first) const {
        return HWY_NAMESPACE::add(turning, cross(loadVector<Tag>(pack.dAB, first), impulse));
    }
};

struct Wrench : WrenchOf<LaneTag> {
    static HWY_INLINE Wrench none() { return {WrenchOf::none()}; }

    HWY_INLINE void actOn(const dxContactPack &pack, unsigned first, Changes &changeA, Changes &changeB) const {
        changeA.push(Masses::load(pack, 0, first), impulse, turning);
        changeB.pull(Masses::load(pack, 1, first), impulse, turningOfB(pack, first));
    }
};

// As forPacks, and adds to the velocities what `work` leaves in the changes of A and B. Lambdas are inlined, or vectors would go through memory:
// walls and pyramids take a twentieth longer then.
template <class Work>
HWY_INLINE void forMovingPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, unsigned minContacts, dxSpatialMotion *velocities,
                               const Work &work) {
    dxSpatialMotion elsewhere[2][dxLanes::kCount] = {};
    const auto move = [&](const dxContactPack &pack, unsigned first, const RelativeMotion &motion) HWY_ATTR __attribute__((always_inline)) {
        Changes changeA = Changes::none(), changeB = Changes::none();
        work(pack, first, motion, changeA, changeB);
        changeA.addTo(pack, 0, first, velocities, elsewhere[0]);
        changeB.addTo(pack, 1, first, velocities, elsewhere[1]);
    };
    forPacks(contacts, begin, end, minContacts, velocities, move);
}

// 1/2 p' softness p - bias' p
HWY_INLINE Lane energyOf(const dxContactLanes &contact, unsigned first) {
    const Lane half = hn::Set(LaneTag(), 0.5f);
    Lane energy = hn::Zero(LaneTag());
    for (unsigned row = 0; row < dxContactLanes::kRows; ++row) {
        const Lane impulse = loadLanes(contact.impulse[row], first);
        const Lane yielding = hn::Mul(half, hn::Mul(loadLanes(contact.softness[row], first), impulse));
        energy = hn::Add(energy, hn::Mul(impulse, hn::Sub(yielding, loadLanes(contact.bias[row], first))));
    }
    return energy;
}

// The kinetic energy changes by the work of the wrench on the mean of the motions before and after it.
double apply(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSpatialMotion *velocities) {
    clearEnergies(contacts.energies, begin, end);
    Energy energy(contacts.energies);
    forMovingPacks(contacts, begin, end, 1, velocities,
                   [&](const dxContactPack &pack, unsigned first, const RelativeMotion &before, Changes &changeA, Changes &changeB) HWY_ATTR {
                       const dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       Wrench wrench = Wrench::none();
                       Lane sum = hn::Zero(LaneTag());
                       for (unsigned k = 0; k < pack.contactCount; ++k) {
                           wrench.addAll(own[k], first);
                           sum = hn::Add(sum, energyOf(own[k], first));
                       }
                       wrench.actOn(pack, first, changeA, changeB);
                       const RelativeMotion twice = RelativeMotion::of(changeA, changeB, loadVector(pack.dAB, first)).plus(before).plus(before);
                       const Lane work = hn::Add(dot(wrench.impulse, twice.v), dot(wrench.turning, twice.w));
                       energy.add(std::size_t(&pack - contacts.packs), hn::Add(sum, hn::Mul(hn::Set(LaneTag(), 0.5f), work)), first);
                   });
    return energy.sum();
}

HWY_INLINE RealWrenches realWrenchesOf(const dxContactPack &pack, const dxContactLanes *contacts) {
    RealWrenches wrenches;
    for (unsigned first = 0; first < dxLanes::kCount; first += kReals) {
        WrenchOf<RealTag> wrench = WrenchOf<RealTag>::none();
        for (unsigned k = 0; k < pack.contactCount; ++k) wrench.addAll(contacts[k], first);
        RealWrenches::store(wrench.impulse, wrenches.impulse, first);
        RealWrenches::store(wrench.turning, wrenches.turning[0], first);
        RealWrenches::store(wrench.turningOfB(pack, first), wrenches.turning[1], first);
    }
    return wrenches;
}

void addImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxIslandBody *masses, dxSpatialMotion *velocities) {
    for (unsigned i = begin; i < end; ++i) {
        const dxContactPack &pack = contacts.packs[i];
        realWrenchesOf(pack, contacts.contacts + pack.firstContact).actOn(pack, masses, velocities);
    }
}

struct Factors {
    Lane normal, friction;

    explicit HWY_INLINE Factors(const dxOverRelaxation &factor)
        : normal(hn::Set(LaneTag(), static_cast<float>(factor.normal))), friction(hn::Set(LaneTag(), static_cast<float>(factor.friction))) {}
};

// Returns the row's residual: bias - softness p - J u.
HWY_INLINE Lane residualOf(const dxContactLanes &contact, unsigned row, const Vector &relative, unsigned first) {
    const Lane yielding = hn::Mul(loadLanes(contact.softness[row], first), loadLanes(contact.impulse[row], first));
    return hn::Sub(hn::Sub(loadLanes(contact.bias[row], first), yielding), dot(loadVector(contact.direction[row], first), relative));
}

// Operations that do not depend on the residual are separate from those that do: a contact takes as long as its longest dependency chain.
HWY_INLINE Lane moved(const dxContactLanes &contact, unsigned row, Lane residual, Lane factor, unsigned first) {
    const Lane step = hn::Mul(factor, loadLanes(contact.effectiveMass[row], first));
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
    const Lane residual = residualOf(contact, kNormal, relative, first);
    const Lane impulse = atLeast(hn::Zero(LaneTag()), moved(contact, kNormal, residual, factor.normal, first));
    return Relaxed::to(impulse, contact, kNormal, residual, first);
}

HWY_INLINE Relaxed relaxTangent(dxContactLanes &contact, int tangent, unsigned first, const Factors &factor, Lane residual, Lane normalImpulse) {
    const unsigned row = 1 + static_cast<unsigned>(tangent);
    const Lane impulse = clamp(limitOf(contact, tangent, normalImpulse, first), moved(contact, row, residual, factor.friction, first));
    return Relaxed::to(impulse, contact, row, residual, first);
}

// Returns the residual of a row after the impulse of a row that is coupled with it has changed.
HWY_INLINE Lane coupled(Lane residual, const dxContactLanes &contact, unsigned coupling, Lane change, unsigned first) {
    return hn::Sub(residual, hn::Mul(loadLanes(contact.coupling[coupling], first), change));
}

// Changes of the impulses of some rows, and the energy of the change.
template <unsigned kRows>
struct Change {
    Lane row[kRows], energy;
};

// Relaxes the normal only.
struct NormalRow {
    static constexpr unsigned kFirstRow = 0, kRows = 1, kMinContacts = 1;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
        const Relaxed normal = relaxNormal(contact, first, factor, relative);
        return {{normal.change}, normal.energy};
    }
};

// Relaxes both tangents.
struct FrictionRows {
    static constexpr unsigned kFirstRow = 1, kRows = 2, kMinContacts = 2;

    static HWY_INLINE Change<kRows> relax(dxContactLanes &contact, unsigned first, const Factors &factor, const Vector &relative) {
        const Lane normalImpulse = loadLanes(contact.impulse[kNormal], first), residual2 = residualOf(contact, 2, relative, first);
        const Relaxed a = relaxTangent(contact, 0, first, factor, residualOf(contact, 1, relative, first), normalImpulse);
        const Relaxed b = relaxTangent(contact, 1, first, factor, coupled(residual2, contact, 2, a.change, first), normalImpulse);
        return {{a.change, b.change}, hn::Add(a.energy, b.energy)};
    }
};

// Relaxes the normal, then friction against its new impulse.
struct AllRows {
    static constexpr unsigned kFirstRow = 0, kRows = 3, kMinContacts = 1;

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

// Contacts begin, begin + step, ... of each manifold are relaxed in `passes` passes while the bodies are in registers: contacts of one
// manifold depend on one another more than on others.
struct Visit {
    unsigned begin, step, passes;
};

// Relaxes the contacts of kLanes manifolds; bodies move after each contact. Returns the energy of the last pass.
template <class Rows>
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, unsigned first, const Visit &visit, const Factors &factor,
                              const RelativeMotion &before, Changes &changeA, Changes &changeB) {
    const Vector dAB = loadVector(pack.dAB, first);
    Lane energy = hn::Zero(LaneTag());
    for (unsigned pass = 0; pass < visit.passes; ++pass) {
        energy = hn::Zero(LaneTag());
        for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step) {
            const RelativeMotion motion = RelativeMotion::of(changeA, changeB, dAB).plus(before);
            const auto change = Rows::relax(contacts[k], first, factor, motion.velocityAt(loadVector(contacts[k].rA, first)));
            Wrench wrench = Wrench::none();
            wrench.add(contacts[k], change.row, Rows::kFirstRow, first);
            wrench.actOn(pack, first, changeA, changeB);
            energy = hn::Add(energy, change.energy);
        }
    }
    return energy;
}

// The same by responses: only the relative motion changes from contact to contact, and the bodies move once, after the last one.
template <class Rows>
HWY_INLINE Lane relaxManifold(const dxContactPack &pack, dxContactLanes *contacts, const dxContactResponse *responses, unsigned first,
                              const Visit &visit, const Factors &factor, const RelativeMotion &before, Changes &changeA, Changes &changeB) {
    const LaneTag d;
    HWY_ALIGN float impulses[dxContactPack::kMaxContacts][Rows::kRows][dxLanes::kCount];
    for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step)
        for (unsigned i = 0; i < Rows::kRows; ++i)
            hn::Store(loadLanes(contacts[k].impulse[Rows::kFirstRow + i], first), d, impulses[k][i]);
    RelativeMotion motion = before;
    Lane energy = hn::Zero(d);
    for (unsigned pass = 0; pass < visit.passes; ++pass) {
        energy = hn::Zero(d);
        for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step) {
            const auto change = Rows::relax(contacts[k], first, factor, motion.velocityAt(loadVector(contacts[k].rA, first)));
            for (unsigned i = 0; i < Rows::kRows; ++i) motion.respond(responses[k].row[Rows::kFirstRow + i], change.row[i], first);
            energy = hn::Add(energy, change.energy);
        }
    }
    Wrench wrench = Wrench::none();
    for (unsigned k = visit.begin; k < pack.contactCount; k += visit.step) {
        Lane changes[Rows::kRows];
        for (unsigned i = 0; i < Rows::kRows; ++i)
            changes[i] = hn::Sub(loadLanes(contacts[k].impulse[Rows::kFirstRow + i], first), hn::Load(d, impulses[k][i]));
        wrench.add(contacts[k], changes, Rows::kFirstRow, first);
    }
    wrench.actOn(pack, first, changeA, changeB);
    return energy;
}

// The same for the normals of all contacts: a change of one normal updates the residuals of all others.
template <>
HWY_INLINE Lane relaxManifold<NormalRow>(const dxContactPack &pack, dxContactLanes *contacts, const dxContactResponse *responses,
                                        unsigned first, const Visit &visit, const Factors &factor, const RelativeMotion &motion,
                                        Changes &changeA, Changes &changeB) {
    const unsigned count = pack.contactCount;
    Lane residual[dxContactPack::kMaxContacts], normalImpulse[dxContactPack::kMaxContacts], energy = hn::Zero(LaneTag());
    for (unsigned k = 0; k < count; ++k) {
        residual[k] = residualOf(contacts[k], 0, motion.velocityAt(loadVector(contacts[k].rA, first)), first);
        normalImpulse[k] = loadLanes(contacts[k].impulse[kNormal], first);
    }
    for (unsigned pass = 0; pass < visit.passes; ++pass) {
        energy = hn::Zero(LaneTag());
        for (unsigned k = 0; k < count; ++k) {
            const Lane step = hn::Mul(factor.normal, loadLanes(contacts[k].effectiveMass[kNormal], first));
            const Lane next = atLeast(hn::Zero(LaneTag()), hn::Add(normalImpulse[k], hn::Mul(residual[k], step)));
            const Lane change = hn::Sub(next, normalImpulse[k]);
            normalImpulse[k] = next;
            energy = hn::Add(energy, hn::Abs(hn::Mul(change, residual[k])));
            for (unsigned i = 0; i < count; ++i)
                residual[i] = hn::Sub(residual[i], hn::Mul(loadLanes(responses[k].normal[i], first), change));
        }
    }
    Wrench wrench = Wrench::none();
    for (unsigned k = 0; k < count; ++k) {
        const Lane change[1] = {hn::Sub(normalImpulse[k], loadLanes(contacts[k].impulse[kNormal], first))};
        wrench.add(contacts[k], change, 0, first);
        storeLanes(normalImpulse[k], contacts[k].impulse[kNormal], first);
    }
    wrench.actOn(pack, first, changeA, changeB);
    return energy;
}

// A single contact has all its rows in the first part of a sweep: no other contact of its manifold depends on it.
template <class Rows>
HWY_INLINE double relaxPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, const Visit &visit,
                             const dxOverRelaxation &relaxation, dxSpatialMotion *velocities) {
    const Factors factor(relaxation);
    Energy energy(contacts.energies);
    forMovingPacks(contacts, begin, end, Rows::kMinContacts, velocities,
                   [&](const dxContactPack &pack, unsigned first, const RelativeMotion &motion, Changes &changeA, Changes &changeB)
                       HWY_ATTR __attribute__((always_inline)) {
                       dxContactLanes *const own = contacts.contacts + pack.firstContact;
                       const dxContactResponse *const responses = responsesOf(contacts, pack);
                       Lane found;
                       if (pack.contactCount == 1)
                           found = relaxManifold<AllRows>(pack, own, first, {0, 1, 1}, factor, motion, changeA, changeB);
                       else if (responses != nullptr)
                           found = relaxManifold<Rows>(pack, own, responses, first, visit, factor, motion, changeA, changeB);
                       else
                           found = relaxManifold<Rows>(pack, own, first, visit, factor, motion, changeA, changeB);
                       energy.add(std::size_t(&pack - contacts.packs), found, first);
                   });
    return energy.sum();
}

double sweep(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, const dxOverRelaxation &factor,
             dxSpatialMotion *velocities) {
    if (dxIsFirst(part)) clearEnergies(contacts.energies, begin, end);
    switch (part) {
    case dxSweepPart::AllRows: return relaxPacks<AllRows>(contacts, begin, end, {0, 1, 2}, factor, velocities);
    case dxSweepPart::Normals: return relaxPacks<NormalRow>(contacts, begin, end, {0, 1, 2}, factor, velocities);
    case dxSweepPart::EvenFriction: return relaxPacks<FrictionRows>(contacts, begin, end, {0, 2, 1}, factor, velocities);
    default: return relaxPacks<FrictionRows>(contacts, begin, end, {1, 2, 1}, factor, velocities);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxContactKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxContactKernels {
HWY_EXPORT(addImpulses);
HWY_EXPORT(apply);
HWY_EXPORT(sweep);
}  // namespace dxContactKernels

double dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSpatialMotion *velocities) {
    using namespace dxContactKernels;
    const dxFlushSubnormals flush;
    return HWY_DYNAMIC_DISPATCH(apply)(contacts, begin, end, velocities);
}

void dxAddImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxIslandBody *masses, dxSpatialMotion *velocities) {
    using namespace dxContactKernels;
    HWY_DYNAMIC_DISPATCH(addImpulses)(contacts, begin, end, masses, velocities);
}

double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, const dxOverRelaxation &factor,
                       dxSpatialMotion *velocities) {
    using namespace dxContactKernels;
    const dxFlushSubnormals flush;
    return HWY_DYNAMIC_DISPATCH(sweep)(contacts, begin, end, part, factor, velocities);
}
#endif
