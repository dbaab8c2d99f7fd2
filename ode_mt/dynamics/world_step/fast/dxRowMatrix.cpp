#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxRowMatrix.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "core/dxNoIndex.h"
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"
#include "dynamics/world_step/fast/dxRowMatrix.h"

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

// J inv(M) of one body, a lane for each row.
HWY_INLINE void multiplyByInverseMass(const dxBodyBlock &rows, const dxInverseMass &inverse, dxBodyBlock &product) {
    const BodyTag d;
    for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
        const auto mass = hn::Set(d, inverse.mass);
        for (unsigned k = 0; k < 3; ++k)
            hn::Store(hn::Mul(hn::Load(d, rows.column[k].lane + lane), mass), d, product.column[k].lane + lane);
        const auto x = hn::Load(d, rows.column[3].lane + lane), y = hn::Load(d, rows.column[4].lane + lane),
                   z = hn::Load(d, rows.column[5].lane + lane);
        for (unsigned k = 0; k < 3; ++k) {
            const auto sum = hn::Add(hn::Mul(x, hn::Set(d, inverse.inertia[0][k])), hn::Mul(y, hn::Set(d, inverse.inertia[1][k])));
            hn::Store(hn::Add(sum, hn::Mul(z, hn::Set(d, inverse.inertia[2][k]))), d, product.column[3 + k].lane + lane);
        }
    }
}

// Row `row` of `byMass` times the rows of `jacobian`, of which there are `count`: store(lane, products).
template <class Store>
HWY_INLINE void multiplyRow(const dxBodyBlock &byMass, unsigned row, const dxBodyBlock &jacobian, unsigned count, Store store) {
    const BodyTag d;
    for (unsigned lane = 0; lane < count; lane += hn::Lanes(d)) {
        const auto product = [&](unsigned k) {
            return hn::Mul(hn::Set(d, byMass.column[k].lane[row]), hn::Load(d, jacobian.column[k].lane + lane));
        };
        const auto linear = hn::Add(hn::Add(product(0), product(1)), product(2));
        const auto angular = hn::Add(hn::Add(product(3), product(4)), product(5));
        store(lane, hn::Add(linear, angular));
    }
}

// A block of two joints without limits: the earlier one's rows.
HWY_INLINE void addToBlock(const dxBodyBlock &byMass, unsigned rows, const dxBodyBlock &jacobian, unsigned count, dxBodyBlock &block) {
    const BodyTag d;
    for (unsigned row = 0; row < rows; ++row)
        multiplyRow(byMass, row, jacobian, count, [&](unsigned lane, hn::Vec<BodyTag> products) {
            double *const to = block.column[row].lane + lane;
            hn::Store(hn::Add(hn::Load(d, to), products), d, to);
        });
}

// Columns that begin anywhere in a row of lines. Those behind them get zeros.
HWY_INLINE void addToLines(const dxBodyBlock &byMass, unsigned row, const dxBodyBlock &jacobian, unsigned count, double *to) {
    const BodyTag d;
    multiplyRow(byMass, row, jacobian, count, [&](unsigned lane, hn::Vec<BodyTag> products) {
        hn::StoreU(hn::Add(hn::LoadU(d, to + lane), products), d, to + lane);
    });
}

class RowMatrix {
public:
    explicit RowMatrix(dxRowBlocks &blocks) : m_blocks(blocks) {}

    void make(const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
        for (std::size_t i = 0; i < m_blocks.parts.size(); ++i)
            for (unsigned side = 0; side < 2; ++side) {
                const unsigned body = m_blocks.parts[i].bodies[side];
                if (body == kNoIndex) continue;
                multiplyByInverseMass(m_blocks.jacobian[2 * i + side], inverseMasses[body], m_blocks.byMass[2 * i + side]);
                subtractMotion(m_blocks.parts[i], m_blocks.jacobian[2 * i + side], motions[body]);
            }
        for (const auto &[later, earlier] : m_blocks.pairs) addPair(later, earlier);
    }

private:
    HWY_INLINE void subtractMotion(const dxRowPart &part, const dxBodyBlock &jacobian, const dxBodyVector &motion) {
        const BodyTag d;
        dxBodyVector sums;
        for (unsigned lane = 0; lane < part.rows; lane += hn::Lanes(d)) {
            auto sum = hn::Mul(hn::Load(d, jacobian.column[0].lane + lane), hn::Set(d, motion.lane[0]));
            for (unsigned k = 1; k < kBodyAxes; ++k)
                sum = hn::Add(sum, hn::Mul(hn::Load(d, jacobian.column[k].lane + lane), hn::Set(d, motion.lane[k])));
            hn::Store(sum, d, sums.lane + lane);
        }
        for (unsigned i = 0; i < part.rows; ++i) {
            double &b = part.isLimited ? dxElement(m_blocks.limitedRow(m_blocks.limited), part.place + i)
                                       : dxElement(m_blocks.besideOf(part.place, i), m_blocks.limited);
            b -= sums.lane[i];
        }
    }

    HWY_INLINE void addPair(unsigned a, unsigned b) {
        const dxRowPart &partA = m_blocks.parts[a / 2], &partB = m_blocks.parts[b / 2];
        if (partA.isLimited && partB.isLimited)
            addLimited(a, b);
        else if (partA.isLimited)
            addBeside(b, a);
        else if (partB.isLimited)
            addBeside(a, b);
        else if (partA.place < partB.place)
            addBelow(a, b);
        else
            addBelow(b, a);
    }

    // The first one is eliminated first.
    HWY_INLINE void addBelow(unsigned first, unsigned second) {
        const dxRowPart &row = m_blocks.parts[first / 2], &column = m_blocks.parts[second / 2];
        dxBodyBlock &block = row.place == column.place ? m_blocks.diagonal[row.place]
                                                       : m_blocks.below[m_blocks.order.findBlock(column.place, row.place)];
        addToBlock(m_blocks.byMass[first], row.rows, m_blocks.jacobian[second], column.rows, block);
    }

    HWY_INLINE void addBeside(unsigned without, unsigned with) {
        const dxRowPart &row = m_blocks.parts[without / 2], &column = m_blocks.parts[with / 2];
        for (unsigned i = 0; i < row.rows; ++i)
            addToLines(m_blocks.byMass[without], i, m_blocks.jacobian[with], column.rows,
                       &dxElement(m_blocks.besideOf(row.place, i), column.place));
        for (unsigned line = column.place / kBodyLanes; line <= (column.place + column.rows - 1) / kBodyLanes; ++line)
            m_blocks.masks[row.place] |= std::uint64_t(1) << line;
    }

    HWY_INLINE void addLimited(unsigned later, unsigned earlier) {
        const dxRowPart &row = m_blocks.parts[later / 2], &column = m_blocks.parts[earlier / 2];
        for (unsigned i = 0; i < row.rows; ++i)
            addToLines(m_blocks.byMass[later], i, m_blocks.jacobian[earlier], column.rows,
                       &dxElement(m_blocks.limitedRow(row.place + i), column.place));
    }

    dxRowBlocks &m_blocks;
};

void makeRowMatrix(dxRowBlocks &blocks, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
    RowMatrix(blocks).make(inverseMasses, motions);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxDirect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxDirect {
HWY_EXPORT(makeRowMatrix);
}  // namespace dxDirect

void dxMakeRowMatrix(dxRowBlocks &blocks, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
    HWY_DYNAMIC_DISPATCH(dxDirect::makeRowMatrix)(blocks, inverseMasses, motions);
}
#endif
