// Packs of contacts in vectors: kLanes manifolds at a time.
//
// Included once for each instruction set, inside HWY_NAMESPACE.
#if defined(DX_CONTACT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DX_CONTACT_LANES_INL_H
#undef DX_CONTACT_LANES_INL_H
#else
#define DX_CONTACT_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "dynamics/quick_step/fast/dxBodyTranspose-inl.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxIterative {
namespace HWY_NAMESPACE {

HWY_INLINE Lane loadLanes(const dxLaneNumbers &numbers, unsigned first) { return hn::Load(LaneTag(), numbers.lane + first); }
HWY_INLINE void storeLanes(Lane lanes, dxLaneNumbers &numbers, unsigned first) {
    hn::Store(lanes, LaneTag(), numbers.lane + first);
}

template <class Tag>
using FloatTag = hn::Rebind<float, Tag>;

template <class Tag = LaneTag>
HWY_INLINE Lane loadFloats(const dxContactResponse::Numbers &numbers, unsigned first) {
    const auto floats = hn::Load(FloatTag<Tag>(), numbers.lane + first);
    if constexpr (sizeof(hn::TFromD<Tag>) == sizeof(float)) {
        return floats;
    } else {
        return hn::PromoteTo(Tag(), floats);
    }
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

    // Adds an impulse in the centre and a turning one.
    HWY_INLINE void push(const Masses &masses, const Vector &impulse, const Vector &turning) {
        v = add(v, scale(impulse, masses.inverse));
        w = add(w, masses.turn(turning));
    }
    HWY_INLINE void pull(const Masses &masses, const Vector &impulse, const Vector &turning) {
        v = subtract(v, scale(impulse, masses.inverse));
        w = subtract(w, masses.turn(turning));
    }
};

// The motion of the first bodies as seen from the second ones, both continued to the first one's centre. An impulse changes it by a
// contact's response, without a look at masses.
struct RelativeMotion {
    Vector v, w;

    static HWY_INLINE RelativeMotion of(const Bodies &body1, const Bodies &body2, const Vector &between) {
        return {subtract(subtract(body1.v, body2.v), cross(body2.w, between)), subtract(body1.w, body2.w)};
    }

    // row: of a dxContactResponse
    static HWY_INLINE RelativeMotion of(const dxContactResponse::Numbers *row, unsigned first) {
        return {{loadFloats(row[0], first), loadFloats(row[1], first), loadFloats(row[2], first)},
                {loadFloats(row[3], first), loadFloats(row[4], first), loadFloats(row[5], first)}};
    }

    HWY_INLINE Vector velocityAt(const Vector &arm) const { return add(v, cross(w, arm)); }

    HWY_INLINE RelativeMotion plus(const RelativeMotion &other) const { return {add(v, other.v), add(w, other.w)}; }

    // row: of a dxContactResponse
    HWY_INLINE void respond(const dxContactResponse::Numbers *row, Lane impulse, unsigned first) {
        const RelativeMotion response = of(row, first);
        v = add(v, scale(response.v, impulse));
        w = add(w, scale(response.w, impulse));
    }
};

// Adds to what belongs to each manifold, and adds it up for each lane, whatever the width of vectors.
class Energy {
public:
    explicit Energy(const dxContactPacks &contacts) : m_contacts(contacts) {}

    HWY_INLINE void add(const dxContactPack &pack, Lane energy, unsigned first) {
        dxLaneNumbers &own = m_contacts.energies[&pack - m_contacts.packs];
        storeLanes(hn::Add(loadLanes(own, first), energy), own, first);
        hn::Store(hn::Add(hn::Load(LaneTag(), m_sum + first), energy), LaneTag(), m_sum + first);
    }
    HWY_INLINE double sum() const {
        double sum = 0;
        for (const dReal energy : m_sum) sum += energy;
        return sum;
    }

private:
    const dxContactPacks &m_contacts;
    HWY_ALIGN dReal m_sum[dxLanes::kCount] = {};
};

HWY_INLINE void clearEnergies(const dxContactPacks &contacts, unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end; ++i) contacts.energies[i] = dxLaneNumbers();
}

// What a friction row may have at the most, where the normal has the impulse `pressure`.
HWY_INLINE Lane limitOf(const dxContactLanes &contact, int tangent, Lane pressure, unsigned first) {
    return hn::Add(hn::Mul(loadLanes(contact.friction[tangent], first), pressure), loadLanes(contact.limit[tangent], first));
}

// Calls work(pack, first lane, bodies of both sides) for kLanes manifolds at a time, of packs with so many contacts at the
// least.
template <class Work>
HWY_INLINE void forPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, unsigned least, const dxVelocity *velocities,
                         const Work &work) {
    for (unsigned i = begin; i < end; ++i) {
        const dxContactPack &pack = contacts.packs[i];
        if (pack.contactCount < least) continue;
        for (unsigned first = 0; first < dxLanes::kCount; first += kLanes) {
            Bodies body1 = Bodies::load(pack, 0, first, velocities), body2 = Bodies::load(pack, 1, first, velocities);
            work(pack, first, body1, body2);
        }
    }
}

// Of a manifold that has more than one contact, if there is room for responses.
HWY_INLINE dxContactResponse *responsesOf(const dxContactPacks &contacts, const dxContactPack &pack) {
    return contacts.responses != nullptr && pack.contactCount > 1 ? contacts.responses + pack.firstContact : nullptr;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxIterative
HWY_AFTER_NAMESPACE();

#endif
