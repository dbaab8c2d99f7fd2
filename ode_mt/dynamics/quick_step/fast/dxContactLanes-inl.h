// Packs of contacts in vectors, kLanes manifolds at a time; velocities of kLanes bodies are transposed to vectors and back.
//
// Included once for each instruction set, inside HWY_NAMESPACE.
#if defined(DX_CONTACT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DX_CONTACT_LANES_INL_H
#undef DX_CONTACT_LANES_INL_H
#else
#define DX_CONTACT_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/step/islands/dxIslandProblem.h"

HWY_BEFORE_NAMESPACE();
namespace dxContactKernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using LaneTag = hn::CappedTag<dReal, dxLanes::kCount>;
using Lane = hn::Vec<LaneTag>;
constexpr unsigned kLanes = hn::MaxLanes(LaneTag());
constexpr unsigned kNormal = dxContactLanes::kNormal, kTangent = dxContactLanes::kTangent;

// Linear and angular velocities of kLanes bodies, by component.
struct Motion {
    Lane v[3], w[3];
};

#if HWY_TARGET != HWY_SCALAR

// A block is two numbers. From [a0 a1 a2 a3] and [b0 ...] they take the even blocks [a0 b0 a2 b2] and the odd ones [a1 b1 a3 b3].
HWY_INLINE Lane evenBlocks(Lane a, Lane b) { return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a); }
HWY_INLINE Lane oddBlocks(Lane a, Lane b) { return hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)); }

// A row is the eight numbers of one body.
HWY_INLINE Motion loadEight(const dReal *const *rows) {
    const LaneTag d;
    Lane low[4], high[4];  // components 0, 2, 4, 6 and 1, 3, 5, 7 of two rows
    for (unsigned i = 0; i < 4; ++i) {
        const Lane a = hn::LoadU(d, rows[2 * i]), b = hn::LoadU(d, rows[2 * i + 1]);
        low[i] = hn::InterleaveLower(d, a, b);
        high[i] = hn::InterleaveUpper(d, a, b);
    }
    const Lane evenLow0 = evenBlocks(low[0], low[1]), evenLow1 = evenBlocks(low[2], low[3]);
    const Lane oddLow0 = oddBlocks(low[0], low[1]), oddLow1 = oddBlocks(low[2], low[3]);
    const Lane evenHigh0 = evenBlocks(high[0], high[1]), evenHigh1 = evenBlocks(high[2], high[3]);
    const Lane oddHigh0 = oddBlocks(high[0], high[1]), oddHigh1 = oddBlocks(high[2], high[3]);
    return {{hn::ConcatLowerLower(d, evenLow1, evenLow0), hn::ConcatLowerLower(d, evenHigh1, evenHigh0),
             hn::ConcatLowerLower(d, oddLow1, oddLow0)},
            {hn::ConcatLowerLower(d, oddHigh1, oddHigh0), hn::ConcatUpperUpper(d, evenLow1, evenLow0),
             hn::ConcatUpperUpper(d, evenHigh1, evenHigh0)}};
}

HWY_INLINE void storeEight(const Motion &motion, dReal *const *rows) {
    const LaneTag d;
    const Lane none = hn::Zero(d);
    const Lane evenLow0 = hn::ConcatLowerLower(d, motion.w[1], motion.v[0]),
               evenLow1 = hn::ConcatUpperUpper(d, motion.w[1], motion.v[0]);
    const Lane evenHigh0 = hn::ConcatLowerLower(d, motion.w[2], motion.v[1]),
               evenHigh1 = hn::ConcatUpperUpper(d, motion.w[2], motion.v[1]);
    const Lane oddLow0 = hn::ConcatLowerLower(d, none, motion.v[2]), oddLow1 = hn::ConcatUpperUpper(d, none, motion.v[2]);
    const Lane oddHigh0 = hn::ConcatLowerLower(d, none, motion.w[0]), oddHigh1 = hn::ConcatUpperUpper(d, none, motion.w[0]);
    const Lane low[4] = {evenBlocks(evenLow0, oddLow0), oddBlocks(evenLow0, oddLow0), evenBlocks(evenLow1, oddLow1),
                         oddBlocks(evenLow1, oddLow1)};
    const Lane high[4] = {evenBlocks(evenHigh0, oddHigh0), oddBlocks(evenHigh0, oddHigh0), evenBlocks(evenHigh1, oddHigh1),
                          oddBlocks(evenHigh1, oddHigh1)};
    for (unsigned i = 0; i < 4; ++i) {
        hn::StoreU(hn::InterleaveLower(d, low[i], high[i]), d, rows[2 * i]);
        hn::StoreU(hn::InterleaveUpper(d, low[i], high[i]), d, rows[2 * i + 1]);
    }
}

// Transpose components [first, first + 4) of four rows.
HWY_INLINE void loadFour(const dReal *const *rows, unsigned first, Lane *columns) {
    const LaneTag d;
    const Lane a = hn::LoadU(d, rows[0] + first), b = hn::LoadU(d, rows[1] + first);
    const Lane c = hn::LoadU(d, rows[2] + first), e = hn::LoadU(d, rows[3] + first);
    const Lane low0 = hn::InterleaveLower(d, a, b), high0 = hn::InterleaveUpper(d, a, b);
    const Lane low1 = hn::InterleaveLower(d, c, e), high1 = hn::InterleaveUpper(d, c, e);
    columns[0] = hn::ConcatLowerLower(d, low1, low0);
    columns[1] = hn::ConcatLowerLower(d, high1, high0);
    columns[2] = hn::ConcatUpperUpper(d, low1, low0);
    columns[3] = hn::ConcatUpperUpper(d, high1, high0);
}

HWY_INLINE void storeFour(const Lane *columns, unsigned first, dReal *const *rows) {
    const LaneTag d;
    const Lane low0 = hn::ConcatLowerLower(d, columns[2], columns[0]), low1 = hn::ConcatUpperUpper(d, columns[2], columns[0]);
    const Lane high0 = hn::ConcatLowerLower(d, columns[3], columns[1]), high1 = hn::ConcatUpperUpper(d, columns[3], columns[1]);
    hn::StoreU(hn::InterleaveLower(d, low0, high0), d, rows[0] + first);
    hn::StoreU(hn::InterleaveUpper(d, low0, high0), d, rows[1] + first);
    hn::StoreU(hn::InterleaveLower(d, low1, high1), d, rows[2] + first);
    hn::StoreU(hn::InterleaveUpper(d, low1, high1), d, rows[3] + first);
}

#endif

// These take any number of lanes, through memory.
HWY_INLINE Motion loadByElements(const dReal *const *rows) {
    const LaneTag d;
    HWY_ALIGN dReal columns[6][dxLanes::kCount];
    for (unsigned row = 0; row < kLanes; ++row)
        for (unsigned i = 0; i < 6; ++i) columns[i][row] = rows[row][i];
    return {{hn::Load(d, columns[0]), hn::Load(d, columns[1]), hn::Load(d, columns[2])},
            {hn::Load(d, columns[3]), hn::Load(d, columns[4]), hn::Load(d, columns[5])}};
}

HWY_INLINE void storeByElements(const Motion &motion, dReal *const *rows) {
    const LaneTag d;
    HWY_ALIGN dReal columns[6][dxLanes::kCount];
    for (unsigned i = 0; i < 3; ++i) {
        hn::Store(motion.v[i], d, columns[i]);
        hn::Store(motion.w[i], d, columns[3 + i]);
    }
    for (unsigned row = 0; row < kLanes; ++row)
        for (unsigned i = 0; i < 6; ++i) rows[row][i] = columns[i][row];
}

// `rows`: kLanes bodies.
HWY_INLINE Motion loadMotion(const dReal *const *rows) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kLanes == 8 && sizeof(dReal) == 8) {
        return loadEight(rows);
    } else if constexpr (kLanes == 4 && sizeof(dReal) == 8) {
        Lane columns[8];
        loadFour(rows, 0, columns);
        loadFour(rows, 4, columns + 4);
        return {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}};
    }
#endif
    return loadByElements(rows);
}

HWY_INLINE void storeMotion(const Motion &motion, dReal *const *rows) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kLanes == 8 && sizeof(dReal) == 8) {
        return storeEight(motion, rows);
    } else if constexpr (kLanes == 4 && sizeof(dReal) == 8) {
        const Lane none = hn::Zero(LaneTag());
        const Lane columns[8] = {motion.v[0], motion.v[1], motion.v[2], motion.w[0], motion.w[1], motion.w[2], none, none};
        storeFour(columns, 0, rows);
        return storeFour(columns + 4, 4, rows);
    }
#endif
    storeByElements(motion, rows);
}

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

// A NaN stays a NaN on every instruction set.
HWY_INLINE Lane atLeast(Lane low, Lane a) { return hn::IfThenElse(hn::Lt(a, low), low, a); }
HWY_INLINE Lane clamp(Lane limit, Lane a) { return hn::IfThenElse(hn::Gt(a, limit), limit, atLeast(hn::Neg(limit), a)); }

HWY_INLINE Vector cross(const Vector &a, const Vector &b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

// The inverse masses of the bodies on one side, A or B.
struct Masses {
    Lane invMass, xx, xy, xz, yy, yz, zz;

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

// The velocities of the bodies on one side, A or B.
struct Bodies {
    Vector v, w;

    static HWY_INLINE Bodies load(const dxContactPack &pack, unsigned side, unsigned first, const dxSpatialMotion *velocities) {
        const dReal *rows[kLanes];
        for (unsigned i = 0; i < kLanes; ++i) rows[i] = velocities[pack.source[side][first + i]].columns;
        const Motion motion = loadMotion(rows);
        return {{motion.v[0], motion.v[1], motion.v[2]}, {motion.w[0], motion.w[1], motion.w[2]}};
    }

    // Bodies that do not move are written to `elsewhere`.
    HWY_INLINE void store(const dxContactPack &pack, unsigned side, unsigned first, dxSpatialMotion *velocities,
                          dxSpatialMotion &elsewhere) const {
        dReal *rows[kLanes];
        for (unsigned i = 0; i < kLanes; ++i) {
            const int target = pack.target[side][first + i];
            rows[i] = target == dxContactPack::kNoBody ? elsewhere.columns : velocities[target].columns;
        }
        storeMotion({{v.x, v.y, v.z}, {w.x, w.y, w.z}}, rows);
    }

    // Adds (subtracts) a linear impulse in the centre and an angular one.
    HWY_INLINE void push(const Masses &masses, const Vector &impulse, const Vector &turning) {
        v = add(v, scale(impulse, masses.invMass));
        w = add(w, masses.turn(turning));
    }
    HWY_INLINE void pull(const Masses &masses, const Vector &impulse, const Vector &turning) {
        v = subtract(v, scale(impulse, masses.invMass));
        w = subtract(w, masses.turn(turning));
    }
};

// The motion of A relative to B, as rigid motions at A's centre. An impulse changes it by the contact's response, which includes the masses.
struct RelativeMotion {
    Vector v, w;

    static HWY_INLINE RelativeMotion of(const Bodies &bodyA, const Bodies &bodyB, const Vector &dAB) {
        return {subtract(subtract(bodyA.v, bodyB.v), cross(bodyB.w, dAB)), subtract(bodyA.w, bodyB.w)};
    }

    // `row`: of a dxContactResponse
    static HWY_INLINE RelativeMotion of(const dxContactResponse::Numbers *row, unsigned first) {
        return {{loadFloats(row[0], first), loadFloats(row[1], first), loadFloats(row[2], first)},
                {loadFloats(row[3], first), loadFloats(row[4], first), loadFloats(row[5], first)}};
    }

    HWY_INLINE Vector velocityAt(const Vector &rA) const { return add(v, cross(w, rA)); }

    HWY_INLINE RelativeMotion plus(const RelativeMotion &other) const { return {add(v, other.v), add(w, other.w)}; }

    // `row`: of a dxContactResponse
    HWY_INLINE void respond(const dxContactResponse::Numbers *row, Lane impulse, unsigned first) {
        const RelativeMotion response = of(row, first);
        v = add(v, scale(response.v, impulse));
        w = add(w, scale(response.w, impulse));
    }
};

// Adds to the energy of each manifold, and to a sum for each of the eight lanes, whatever the width of vectors.
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

// Returns the largest impulse that a friction row may have beside this impulse of the normal.
HWY_INLINE Lane limitOf(const dxContactLanes &contact, int tangent, Lane normalImpulse, unsigned first) {
    return hn::Add(hn::Mul(loadLanes(contact.friction[tangent], first), normalImpulse), loadLanes(contact.limit[tangent], first));
}

// Calls work(pack, first lane, bodies A, bodies B) for kLanes manifolds at a time, of packs of at least `minContacts` contacts.
template <class Work>
HWY_INLINE void forPacks(const dxContactPacks &contacts, unsigned begin, unsigned end, unsigned minContacts, const dxSpatialMotion *velocities,
                         const Work &work) {
    for (unsigned i = begin; i < end; ++i) {
        const dxContactPack &pack = contacts.packs[i];
        if (pack.contactCount < minContacts) continue;
        for (unsigned first = 0; first < dxLanes::kCount; first += kLanes) {
            Bodies bodyA = Bodies::load(pack, 0, first, velocities), bodyB = Bodies::load(pack, 1, first, velocities);
            work(pack, first, bodyA, bodyB);
        }
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
