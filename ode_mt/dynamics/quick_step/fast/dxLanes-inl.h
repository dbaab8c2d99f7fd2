// Lanes in vectors, kLanes constraints at a time; velocities of kLanes bodies are transposed to vectors and back.
//
// Included once for each instruction set, inside HWY_NAMESPACE.
#if defined(DX_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DX_LANES_INL_H
#undef DX_LANES_INL_H
#else
#define DX_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "dynamics/quick_step/fast/dxLanes.h"

HWY_BEFORE_NAMESPACE();
namespace dxLaneKernels {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using LaneTag = hn::CappedTag<float, dxLanes::kCount>;
using Lane = hn::Vec<LaneTag>;
constexpr unsigned kLanes = hn::MaxLanes(LaneTag());

// Velocities of kLanes bodies, by component: linear, then angular.
struct Motion {
    Lane column[6];
};

#if HWY_MAX_BYTES >= 32

using RowTag = hn::CappedTag<float, 8>;  // six velocities of one body, and two zeros
using PairTag = hn::Repartition<double, LaneTag>;

// Calls load(tag, offset), which returns dReals of a body's row from an offset on, and returns the row as floats.
template <class Row = RowTag, class Load>
HWY_INLINE hn::Vec<Row> loadRow(const Load &load) {
    const Row d;
    const hn::Half<Row> half;
    const hn::Half<decltype(half)> quarter;
    if constexpr (sizeof(dReal) == sizeof(float)) {
        return load(d, 0);
    } else if constexpr (HWY_MAX_BYTES >= 8 * sizeof(dReal)) {
        return hn::DemoteTo(d, load(hn::Rebind<dReal, Row>(), 0));
    } else {
        const auto low = hn::DemoteTo(half, load(hn::Rebind<dReal, decltype(half)>(), 0));
        return hn::Combine(d, hn::ZeroExtendVector(half, hn::DemoteTo(quarter, load(hn::Rebind<dReal, decltype(quarter)>(), 4))), low);
    }
}

// Numbers of a row from an offset on, and zeros behind them.
template <class Tag>
HWY_INLINE hn::Vec<Tag> loadSix(Tag d, const dReal *row, unsigned offset) {
    if constexpr (hn::MaxLanes(Tag()) == 8) {
        return hn::MaskedLoad(hn::FirstN(d, 6), d, row);
    } else {
        return hn::LoadU(d, row + offset);
    }
}

struct BodyRow {
    const dReal *const *rows;
    HWY_INLINE hn::Vec<RowTag> operator()(unsigned i) const {
        return loadRow([this, i](auto d, unsigned offset) HWY_ATTR { return loadSix(d, rows[i], offset); });
    }
};

// The difference of two rows, which is rounded to floats afterwards: two bodies may move together much faster than they move apart.
struct BodyRowDifference {
    const dReal *const *rows, *const *others;
    HWY_INLINE hn::Vec<RowTag> operator()(unsigned i) const {
        return loadRow([this, i](auto d, unsigned offset) HWY_ATTR { return hn::Sub(loadSix(d, rows[i], offset), loadSix(d, others[i], offset)); });
    }
};

// Adds floats to the dReals of a row.
template <class Row = RowTag>
HWY_INLINE void addRow(hn::Vec<Row> change, dReal *row) {
    const Row d;
    const hn::Half<Row> half;
    const hn::Half<decltype(half)> quarter;
    if constexpr (sizeof(dReal) == sizeof(float)) {
        hn::StoreU(hn::Add(loadSix(d, row, 0), change), d, row);
    } else if constexpr (HWY_MAX_BYTES >= 8 * sizeof(dReal)) {
        const hn::Rebind<dReal, Row> eight;
        hn::StoreU(hn::Add(loadSix(eight, row, 0), hn::PromoteTo(eight, change)), eight, row);
    } else {
        const hn::Rebind<dReal, decltype(half)> four;
        const hn::Rebind<dReal, decltype(quarter)> two;
        const auto high = hn::LowerHalf(quarter, hn::UpperHalf(half, change));
        hn::StoreU(hn::Add(loadSix(four, row, 0), hn::PromoteTo(four, hn::LowerHalf(half, change))), four, row);
        hn::StoreU(hn::Add(loadSix(two, row, 4), hn::PromoteTo(two, high)), two, row + 4);
    }
}

// A block is four numbers. From [a0 a1 a2 a3] and [b0 ...] these take the even blocks [a0 b0 a2 b2] and the odd ones [a1 b1 a3 b3].
HWY_INLINE Lane evenBlocks(Lane a, Lane b) { return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a); }
HWY_INLINE Lane oddBlocks(Lane a, Lane b) { return hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)); }

// Transposes the 4 x 4 numbers of each block.
HWY_INLINE void transposeBlocks(Lane (&rows)[4]) {
    const LaneTag d;
    const PairTag pairs;
    const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(d, rows[0], rows[1]));
    const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(d, rows[2], rows[3]));
    const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(d, rows[0], rows[1]));
    const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(d, rows[2], rows[3]));
    rows[0] = hn::BitCast(d, hn::InterleaveLower(pairs, low01, low23));
    rows[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, low01, low23));
    rows[2] = hn::BitCast(d, hn::InterleaveLower(pairs, high01, high23));
    rows[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, high01, high23));
}

// Row i, and beside it row i + 8 where vectors have 16 numbers.
template <class Row, class Tag = LaneTag>
HWY_INLINE hn::Vec<Tag> loadRows(const Row &row, unsigned i) {
    if constexpr (hn::MaxLanes(Tag()) == 16) {
        return hn::Combine(Tag(), row(i + 8), row(i));
    } else {
        return row(i);
    }
}

template <class Tag = LaneTag>
HWY_INLINE void addRows(hn::Vec<Tag> changes, dReal *const *rows, unsigned i) {
    if constexpr (hn::MaxLanes(Tag()) == 16) {
        addRow(hn::LowerHalf(RowTag(), changes), rows[i]);
        addRow(hn::UpperHalf(hn::Half<Tag>(), changes), rows[i + 8]);
    } else {
        addRow(changes, rows[i]);
    }
}

template <class Row>
HWY_INLINE Motion loadByBlocks(const Row &row) {
    Lane a[4], b[4];  // rows 0 to 3 and 4 to 7; then columns, of which 0 to 3 are in even blocks
    for (unsigned i = 0; i < 4; ++i) {
        a[i] = loadRows(row, i);
        b[i] = loadRows(row, i + 4);
    }
    transposeBlocks(a);
    transposeBlocks(b);
    return {{evenBlocks(a[0], b[0]), evenBlocks(a[1], b[1]), evenBlocks(a[2], b[2]), evenBlocks(a[3], b[3]), oddBlocks(a[0], b[0]),
             oddBlocks(a[1], b[1])}};
}

HWY_INLINE void addMotion(const Motion &change, dReal *const *rows) {
    const Lane none = hn::Zero(LaneTag());
    const Lane *const column = change.column;
    Lane a[4] = {evenBlocks(column[0], column[4]), evenBlocks(column[1], column[5]), evenBlocks(column[2], none), evenBlocks(column[3], none)};
    Lane b[4] = {oddBlocks(column[0], column[4]), oddBlocks(column[1], column[5]), oddBlocks(column[2], none), oddBlocks(column[3], none)};
    transposeBlocks(a);
    transposeBlocks(b);
    for (unsigned i = 0; i < 4; ++i) {
        addRows(a[i], rows, i);
        addRows(b[i], rows, i + 4);
    }
}

// `rows`: kLanes bodies.
HWY_INLINE Motion loadMotion(const dReal *const *rows) { return loadByBlocks(BodyRow{rows}); }

// Returns the velocities of bodies relative to others.
HWY_INLINE Motion loadDifference(const dReal *const *rows, const dReal *const *others) { return loadByBlocks(BodyRowDifference{rows, others}); }

#else

// These take any number of lanes, through memory.
template <class Number>
HWY_INLINE Motion loadByElements(const Number &number) {
    HWY_ALIGN float columns[6][dxLanes::kCount];
    for (unsigned row = 0; row < kLanes; ++row)
        for (unsigned i = 0; i < 6; ++i) columns[i][row] = static_cast<float>(number(row, i));
    Motion motion;
    for (unsigned i = 0; i < 6; ++i) motion.column[i] = hn::Load(LaneTag(), columns[i]);
    return motion;
}

HWY_INLINE Motion loadMotion(const dReal *const *rows) {
    return loadByElements([rows](unsigned row, unsigned i) { return rows[row][i]; });
}

HWY_INLINE Motion loadDifference(const dReal *const *rows, const dReal *const *others) {
    return loadByElements([rows, others](unsigned row, unsigned i) { return rows[row][i] - others[row][i]; });
}

HWY_INLINE void addMotion(const Motion &change, dReal *const *rows) {
    HWY_ALIGN float columns[6][dxLanes::kCount];
    for (unsigned i = 0; i < 6; ++i) hn::Store(change.column[i], LaneTag(), columns[i]);
    for (unsigned row = 0; row < kLanes; ++row)
        for (unsigned i = 0; i < 6; ++i) rows[row][i] += columns[i][row];
}

#endif

// As numbers of the tag: floats, or dReals.
template <class Tag = LaneTag>
HWY_INLINE hn::Vec<Tag> loadLanes(const dxLaneNumbers &numbers, unsigned first) {
    const auto floats = hn::Load(hn::Rebind<float, Tag>(), numbers.lane + first);
    if constexpr (sizeof(hn::TFromD<Tag>) == sizeof(float)) {
        return floats;
    } else {
        return hn::PromoteTo(Tag(), floats);
    }
}
HWY_INLINE void storeLanes(Lane lanes, dxLaneNumbers &numbers, unsigned first) {
    hn::Store(lanes, LaneTag(), numbers.lane + first);
}

template <class Number>
struct VectorOf {
    Number x, y, z;
};
using Vector = VectorOf<Lane>;

template <class Tag = LaneTag>
HWY_INLINE VectorOf<hn::Vec<Tag>> loadVector(const dxLaneNumbers *numbers, unsigned first) {
    return {loadLanes<Tag>(numbers[0], first), loadLanes<Tag>(numbers[1], first), loadLanes<Tag>(numbers[2], first)};
}

HWY_INLINE void storeVector(const Vector &vector, dxLaneNumbers *numbers, unsigned first) {
    storeLanes(vector.x, numbers[0], first);
    storeLanes(vector.y, numbers[1], first);
    storeLanes(vector.z, numbers[2], first);
}

HWY_INLINE Lane dot(const Vector &a, const Vector &b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <class Number>
HWY_INLINE VectorOf<Number> add(const VectorOf<Number> &a, const VectorOf<Number> &b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class Number>
HWY_INLINE VectorOf<Number> subtract(const VectorOf<Number> &a, const VectorOf<Number> &b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class Number>
HWY_INLINE VectorOf<Number> scale(const VectorOf<Number> &a, Number factor) {
    return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

// A NaN stays a NaN on every instruction set.
HWY_INLINE Lane atLeast(Lane low, Lane a) { return hn::IfThenElse(hn::Lt(a, low), low, a); }
HWY_INLINE Lane clamp(Lane limit, Lane a) { return hn::IfThenElse(hn::Gt(a, limit), limit, atLeast(hn::Neg(limit), a)); }

// Returns 0 for 0, without dividing by it: a program may trap divisions by zero.
HWY_INLINE Lane inverseOf(Lane a) {
    const Lane one = hn::Set(LaneTag(), 1.0f), none = hn::Zero(LaneTag());
    const auto isNone = hn::Eq(a, none);
    return hn::IfThenElse(isNone, none, hn::Div(one, hn::IfThenElse(isNone, one, a)));
}

template <class Number>
HWY_INLINE VectorOf<Number> cross(const VectorOf<Number> &a, const VectorOf<Number> &b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

// The inverse masses of the bodies on one side, A or B.
struct Masses {
    Lane invMass, xx, xy, xz, yy, yz, zz;

    static HWY_INLINE Masses load(const dxLaneBodies &pack, unsigned side, unsigned first) {
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

// How the velocities of the bodies on one side, A or B, change.
struct Changes {
    Vector v, w;

    static HWY_INLINE Changes none() {
        const Lane zero = hn::Zero(LaneTag());
        return {{zero, zero, zero}, {zero, zero, zero}};
    }

    // Adds them to the velocities; those of bodies that do not move are added to `elsewhere`, by lane: additions
    // to one place would wait for one another.
    HWY_INLINE void addTo(const dxLaneBodies &pack, unsigned side, unsigned first, dxSpatialMotion *velocities, dxSpatialMotion *elsewhere) const {
        dReal *rows[kLanes];
        for (unsigned i = 0; i < kLanes; ++i) {
            const int target = pack.target[side][first + i];
            rows[i] = target == dxLaneBodies::kNoBody ? elsewhere[first + i].columns : velocities[target].columns;
        }
        addMotion({{v.x, v.y, v.z, w.x, w.y, w.z}}, rows);
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

// Adds to the energy of each constraint of a pack, and to a sum for each lane, whatever the width of vectors.
class Energy {
public:
    // `energies`: by pack
    explicit Energy(dxLaneNumbers *energies) : m_energies(energies) {}

    HWY_INLINE void add(std::size_t pack, Lane energy, unsigned first) {
        dxLaneNumbers &own = m_energies[pack];
        storeLanes(hn::Add(loadLanes(own, first), energy), own, first);
        hn::Store(hn::Add(hn::Load(LaneTag(), m_sum + first), energy), LaneTag(), m_sum + first);
    }
    HWY_INLINE double sum() const {
        double sum = 0;
        for (const float energy : m_sum) sum += static_cast<double>(energy);
        return sum;
    }

private:
    dxLaneNumbers *const m_energies;
    HWY_ALIGN float m_sum[dxLanes::kCount] = {};
};

HWY_INLINE void clearEnergies(dxLaneNumbers *energies, unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end; ++i) energies[i] = dxLaneNumbers();
}

using RealTag = hn::CappedTag<dReal, 8>;
constexpr unsigned kReals = hn::MaxLanes(RealTag());

// What the impulses of each constraint of a pack are in all: a linear impulse, and an angular one in the centre of A and of B. On B they act
// reversed.
struct RealWrenches {
    HWY_ALIGN dReal impulse[3][dxLanes::kCount], turning[2][3][dxLanes::kCount];

    static HWY_INLINE void store(const VectorOf<hn::Vec<RealTag>> &vector, dReal (&numbers)[3][dxLanes::kCount], unsigned first) {
        hn::Store(vector.x, RealTag(), numbers[0] + first);
        hn::Store(vector.y, RealTag(), numbers[1] + first);
        hn::Store(vector.z, RealTag(), numbers[2] + first);
    }

    HWY_INLINE void actOn(const dxLaneBodies &bodies, const dxIslandBody *masses, dxSpatialMotion *velocities) const {
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
            for (unsigned side = 0; side < 2; ++side) {
                const int target = bodies.target[side][lane];
                if (target != dxLaneBodies::kNoBody) actOn(masses[target], side, lane, velocities[target].columns);
            }
    }

private:
    HWY_INLINE void actOn(const dxIslandBody &masses, unsigned side, unsigned lane, dReal *velocity) const {
        const dReal sign = side == 0 ? dReal(1) : dReal(-1);
        for (unsigned i = 0; i < 3; ++i) {
            const dReal *const inertia = masses.invInertia + 3 * i;
            const dReal turned = inertia[0] * turning[side][0][lane] + inertia[1] * turning[side][1][lane] + inertia[2] * turning[side][2][lane];
            velocity[i] += sign * masses.invMass * impulse[i][lane];
            velocity[3 + i] += sign * turned;
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace dxLaneKernels
HWY_AFTER_NAMESPACE();

#endif
