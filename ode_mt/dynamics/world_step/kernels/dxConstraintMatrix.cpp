#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxConstraintMatrix.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "dynamics/world_step/kernels/dxConstraintMatrix.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr unsigned kWidest = 4;        // lanes: most joints have three to six rows
constexpr unsigned kWidestBlock = 8;   // rows of a joint in whole vectors
static_assert(kWidest <= dxConstraintMatrixTask::kSlack, "vectors end within the slack");

#if HWY_TARGET == HWY_SCALAR  // which has no halves

template <unsigned Count, class D>
HWY_INLINE void storeFirst(hn::Vec<D> lane, D d, dReal *to) {
    hn::StoreU(lane, d, to);
}

#else

// The first Count lanes.
template <unsigned Count, class D>
HWY_INLINE void storeFirst(hn::Vec<D> lanes, D d, dReal *to) {
    if constexpr (Count == hn::MaxLanes(d)) {
        hn::StoreU(lanes, d, to);
    } else {
        const hn::Half<D> half;
        constexpr unsigned kHalf = hn::MaxLanes(half);
        if constexpr (Count <= kHalf) {
            storeFirst<Count>(hn::LowerHalf(half, lanes), half, to);
        } else {
            hn::StoreU(hn::LowerHalf(half, lanes), half, to);
            storeFirst<Count - kHalf>(hn::UpperHalf(half, lanes), half, to + kHalf);
        }
    }
}

#endif

// What elements of a block are before the sum is added.
struct StartAtZero {
    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, unsigned, unsigned, const dReal *) const {
        return hn::Zero(d);
    }
};

struct StartAsTheyAre {
    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, unsigned, unsigned, const dReal *elements) const {
        return hn::LoadU(d, elements);
    }
};

struct StartWithSoftness {
    const dReal *pairs;  // of the joint's rows

    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, unsigned row, unsigned column, const dReal *) const {
        const auto isDiagonal = hn::Eq(hn::Iota(d, static_cast<dReal>(column)), hn::Set(d, static_cast<dReal>(row)));
        return hn::IfThenElseZero(isDiagonal, hn::Set(d, pairs[2 * row + 1]));
    }
};

template <class D>
class ConstraintMatrix {
public:
    HWY_INLINE explicit ConstraintMatrix(const dxConstraintMatrixTask &task) : m_task(task) {}

    HWY_INLINE void make() {
        for (unsigned i = 0; i < m_task.jointCount; ++i) makeRows(i);
    }

private:
    static constexpr unsigned kLanes = hn::MaxLanes(D());

    HWY_INLINE dReal *rowsByElement(const dxConstraintJoint &joint, unsigned side) const {
        const std::size_t row = std::size_t(joint.firstRow) * dxBodyLinks::kSides + std::size_t(side) * joint.rows;
        return m_task.transposed + row * kRowElements;
    }

    HWY_INLINE void makeRows(unsigned index) {
        const dxConstraintJoint &joint = m_task.joints[index];
        clear(joint);
        for (unsigned side = 0; side < dxBodyLinks::kSides && joint.bodies[side] != dxConstraintJoint::kNoBody; ++side)
            addBody(index, joint, side);
    }

    // Before the diagonal block.
    HWY_INLINE void clear(const dxConstraintJoint &joint) {
        const D d;
        dReal *row = m_task.matrix + m_task.rowSkip * joint.firstRow;
        for (unsigned i = 0; i < joint.rows; ++i, row += m_task.rowSkip)
            for (unsigned j = 0; j < joint.firstRow; j += kLanes) hn::StoreU(hn::Zero(d), d, row + j);
    }

    HWY_INLINE void addBody(unsigned index, const dxConstraintJoint &joint, unsigned side) {
        transpose(joint, side);
        multiplyByInverseMass(joint, side);
        if (side == 0)
            addBlock(joint, joint, side, StartWithSoftness{m_task.pairs + std::size_t(2) * joint.firstRow});
        else
            addBlock(joint, joint, side, StartAsTheyAre());
        for (unsigned link = m_task.links.after(dxBodyLinks::linkOf(index, side)); link != dxBodyLinks::kNone;
             link = m_task.links.after(link)) {
            const dxConstraintJoint &other = m_task.joints[dxBodyLinks::jointOf(link)];
            const bool hasMetBefore = side == 1 && (other.bodies[0] == joint.bodies[0] || other.bodies[1] == joint.bodies[0]);
            if (hasMetBefore)
                addBlock(joint, other, dxBodyLinks::sideOf(link), StartAsTheyAre());
            else
                addBlock(joint, other, dxBodyLinks::sideOf(link), StartAtZero());
        }
        subtractMotion(joint, side);
    }

    HWY_INLINE void transpose(const dxConstraintJoint &joint, unsigned side) {
        dReal *const to = rowsByElement(joint, side);
        const dReal *row = m_task.jacobian + (to - m_task.transposed);
        for (unsigned i = 0; i < joint.rows; ++i, row += kRowElements)
            for (unsigned k = 0; k < kRowElements; ++k) to[k * joint.rows + i] = row[k];
    }

    // J inv(M), a lane for each row.
    HWY_INLINE void multiplyByInverseMass(const dxConstraintJoint &joint, unsigned side) {
        const D d;
        const dReal *const rows = rowsByElement(joint, side);
        const dReal *const inertia = m_task.inverseInertia + std::size_t(12) * joint.bodies[side];
        const auto mass = hn::Set(d, inertia[dxConstraintMatrixTask::kInverseMass]);
        for (unsigned i = 0; i < joint.rows; i += kLanes) {
            for (unsigned k = 0; k < 3; ++k)
                hn::Store(hn::Mul(hn::LoadU(d, rows + k * joint.rows + i), mass), d, m_byMass[k] + i);
            const auto x = hn::LoadU(d, rows + 3 * joint.rows + i), y = hn::LoadU(d, rows + 4 * joint.rows + i),
                       z = hn::LoadU(d, rows + 5 * joint.rows + i);
            for (unsigned k = 0; k < 3; ++k) {
                const auto sum = hn::Add(hn::Mul(hn::Set(d, inertia[k]), x), hn::Mul(hn::Set(d, inertia[4 + k]), y));
                hn::Store(hn::Add(sum, hn::Mul(hn::Set(d, inertia[8 + k]), z)), d, m_byMass[3 + k] + i);
            }
        }
    }

    HWY_INLINE void subtractMotion(const dxConstraintJoint &joint, unsigned side) {
        const D d;
        const dReal *const rows = rowsByElement(joint, side);
        const dReal *const motion = m_task.motions + std::size_t(kRowElements) * joint.bodies[side];
        HWY_ALIGN dReal sums[kWidestBlock];
        for (unsigned i = 0; i < joint.rows; i += kLanes) {
            auto sum = hn::Mul(hn::LoadU(d, rows + i), hn::Set(d, motion[0]));
            for (unsigned k = 1; k < kRowElements; ++k)
                sum = hn::Add(sum, hn::Mul(hn::LoadU(d, rows + k * joint.rows + i), hn::Set(d, motion[k])));
            hn::Store(sum, d, sums + i);
        }
        for (unsigned i = 0; i < joint.rows; ++i) m_task.pairs[2 * (std::size_t(joint.firstRow) + i)] -= sums[i];
    }

    template <class Start>
    HWY_INLINE void addBlock(const dxConstraintJoint &joint, const dxConstraintJoint &other, unsigned side, Start start) {
        dReal *const block = m_task.matrix + m_task.rowSkip * joint.firstRow + other.firstRow;
        const dReal *const columns = rowsByElement(other, side);
        switch (other.rows) {
            case 1: return addColumns<1>(joint.rows, columns, block, start);
            case 2: return addColumns<2>(joint.rows, columns, block, start);
            case 3: return addColumns<3>(joint.rows, columns, block, start);
            case 4: return addColumns<4>(joint.rows, columns, block, start);
            case 5: return addColumns<5>(joint.rows, columns, block, start);
            default: return addColumns<kMaxJointRows>(joint.rows, columns, block, start);
        }
    }

    // Columns from Begin on: those of a vector for all rows, so that they stay in registers, then the others.
    template <unsigned Columns, unsigned Begin = 0, class Start>
    HWY_INLINE void addColumns(unsigned rows, const dReal *columns, dReal *block, Start start) {
        const D d;
        hn::Vec<D> lanes[kRowElements];
        for (unsigned k = 0; k < kRowElements; ++k) lanes[k] = hn::LoadU(d, columns + k * Columns + Begin);
        dReal *elements = block + Begin;
        for (unsigned i = 0; i < rows; ++i, elements += m_task.rowSkip) {
            auto sum = hn::Mul(hn::Set(d, m_byMass[0][i]), lanes[0]);
            for (unsigned k = 1; k < kRowElements; ++k) sum = hn::Add(sum, hn::Mul(hn::Set(d, m_byMass[k][i]), lanes[k]));
            storeFirst<HWY_MIN(Columns - Begin, kLanes)>(hn::Add(start(d, i, Begin, elements), sum), d, elements);
        }
        if constexpr (Begin + kLanes < Columns) addColumns<Columns, Begin + kLanes>(rows, columns, block, start);
    }

    const dxConstraintMatrixTask &m_task;
    HWY_ALIGN dReal m_byMass[kRowElements][kWidestBlock];  // J inv(M) of the present joint and body, by element
};

void makeConstraintMatrix(const dxConstraintMatrixTask &task, bool mayUseLanes) {
    if (mayUseLanes)
        ConstraintMatrix<hn::CappedTag<dReal, kWidest>>(task).make();
    else
        ConstraintMatrix<hn::CappedTag<dReal, 1>>(task).make();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(makeConstraintMatrix);
}  // namespace dxSolve

void dxMakeConstraintMatrix(const dxConstraintMatrixTask &task, bool mayUseLanes) {
    HWY_DYNAMIC_DISPATCH(dxSolve::makeConstraintMatrix)(task, mayUseLanes);
}
#endif
