#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxRowBlocks.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "core/dxNoIndex.h"
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
namespace HWY_NAMESPACE {

// --- making the blocks -------------------------------------------------------------------------------------

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

// A block of two joints' bilateral rows: the earlier one's rows.
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
                multiplyByInverseMass<kBodyLanes, true>(m_blocks.jacobian[2 * i + side].column[0].lane, inverseMasses[body],
                                                        m_blocks.byMass[2 * i + side].column[0].lane);
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
            double &b = part.isUnilateral ? dxElement(m_blocks.unilateralRow(m_blocks.unilateralCount), part.place + i)
                                       : dxElement(m_blocks.besideOf(part.place, i), m_blocks.unilateralCount);
            b -= sums.lane[i];
        }
    }

    HWY_INLINE void addPair(unsigned a, unsigned b) {
        const dxRowPart &partA = m_blocks.parts[a / 2], &partB = m_blocks.parts[b / 2];
        if (partA.isUnilateral && partB.isUnilateral)
            addUnilateral(a, b);
        else if (partA.isUnilateral)
            addBeside(b, a);
        else if (partB.isUnilateral)
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

    HWY_INLINE void addUnilateral(unsigned later, unsigned earlier) {
        const dxRowPart &row = m_blocks.parts[later / 2], &column = m_blocks.parts[earlier / 2];
        for (unsigned i = 0; i < row.rows; ++i)
            addToLines(m_blocks.byMass[later], i, m_blocks.jacobian[earlier], column.rows,
                       &dxElement(m_blocks.unilateralRow(row.place + i), column.place));
    }

    dxRowBlocks &m_blocks;
};

void makeRowMatrix(dxRowBlocks &blocks, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
    RowMatrix(blocks).make(inverseMasses, motions);
}

// --- elimination -------------------------------------------------------------------------------------------

// The position of the lowest bit, which is removed.
HWY_INLINE unsigned takeLowest(std::uint64_t &mask) {
    const unsigned lowest = hwy::Num0BitsBelowLS1Bit_Nonzero64(mask);
    mask &= mask - 1;
    return lowest;
}

// row(i) -= the sum over p < Count of factors.column[p].lane[i] * source(p), for i < rows, over `width` columns.
template <unsigned Count, class Source, class Row>
HWY_INLINE void subtractProducts(const dxBodyBlock &factors, unsigned rows, unsigned width, Source source, Row row) {
    const BodyTag d;
    for (unsigned lane = 0; lane < width; lane += hn::Lanes(d)) {
        hn::Vec<BodyTag> sources[Count];
        for (unsigned p = 0; p < Count; ++p) sources[p] = hn::Load(d, source(p).lane + lane);
        for (unsigned i = 0; i < rows; ++i) {
            double *const to = row(i).lane + lane;
            auto sum = hn::Load(d, to);
            HWY_UNROLL(6) for (unsigned p = 0; p < Count; ++p)
                sum = hn::Sub(sum, hn::Mul(hn::Set(d, factors.column[p].lane[i]), sources[p]));
            hn::Store(sum, d, to);
        }
    }
}

class RowElimination {
public:
    explicit RowElimination(dxRowBlocks &blocks) : m_blocks(blocks), m_order(blocks.order) {}

    bool eliminate() {
        for (unsigned place = 0; place < m_order.bodyCount(); ++place)
            if (!eliminateJoint(place)) return false;
        for (unsigned place = 0; place < m_order.bodyCount() && m_blocks.unilateralCount > 0; ++place) reduceUnilateralRows(place);
        return true;
    }

private:
    bool eliminateJoint(unsigned place) {
        double before[kBodyAxes];
        dxBodyBlock &diagonal = m_blocks.diagonal[place];
        for (unsigned i = 0; i < m_blocks.sizes[place]; ++i) before[i] = diagonal.column[i].lane[i];
        const unsigned begin = m_order.firstBlock(place), end = m_order.firstBlock(place + 1);
        for (unsigned block = begin; block < end; ++block) m_blocks.slotOf[m_order.rowOf(block)] = block;
        for (unsigned e = m_order.firstEntry(place); e < m_order.firstEntry(place + 1); ++e) subtractEarlier(place, m_order.entry(e));
        if (!factorPivot(place, before)) return false;
        for (unsigned block = begin; block < end; ++block)
            divideRows(place, m_blocks.sizes[m_order.rowOf(block)],
                       [&](unsigned i) -> dxBodyVector & { return m_blocks.below[block].column[i]; });
        for (std::uint64_t mask = m_blocks.masks[place]; mask != 0;) {
            const unsigned line = takeLowest(mask);
            divideRows(place, kBodyLanes, [&](unsigned i) -> dxBodyVector & { return m_blocks.besideOf(place, i)[line]; });
        }
        return true;
    }

    // The products of an earlier joint's rows.
    HWY_INLINE void subtractEarlier(unsigned place, const dxEliminationOrder::RowEntry &entry) {
        withRows(m_blocks.sizes[entry.column], [&](auto count) HWY_ATTR { subtractEarlierRows<decltype(count)::value>(place, entry); });
    }

    template <unsigned Count>
    HWY_INLINE void subtractEarlierRows(unsigned place, const dxEliminationOrder::RowEntry &entry) {
        const dxBodyBlock &own = m_blocks.below[entry.block];
        dxBodyBlock factors;
        scaleRows<Count>(entry.column, own, factors);
        const unsigned rows = m_blocks.sizes[place];
        const auto subtractFrom = [&](dxBodyBlock &target, unsigned source, unsigned width) {
            subtractProducts<Count>(
                factors, rows, width, [&](unsigned p) -> const dxBodyVector & { return m_blocks.below[source].column[p]; },
                [&](unsigned i) -> dxBodyVector & { return target.column[i]; });
        };
        subtractFrom(m_blocks.diagonal[place], entry.block, rows);
        for (unsigned source = entry.block + 1; source < m_order.firstBlock(entry.column + 1); ++source) {
            const unsigned other = m_order.rowOf(source);
            subtractFrom(m_blocks.below[m_blocks.slotOf[other]], source, m_blocks.sizes[other]);
        }
        m_blocks.masks[place] |= m_blocks.masks[entry.column];
        for (std::uint64_t mask = m_blocks.masks[entry.column]; mask != 0;) {
            const unsigned line = takeLowest(mask);
            subtractProducts<Count>(
                factors, rows, kBodyLanes,
                [&](unsigned p) -> const dxBodyVector & { return m_blocks.besideOf(entry.column, p)[line]; },
                [&](unsigned i) -> dxBodyVector & { return m_blocks.besideOf(place, i)[line]; });
        }
    }

    // inv(D) times rows.
    template <unsigned Count>
    HWY_INLINE void scaleRows(unsigned place, const dxBodyBlock &rows, dxBodyBlock &scaled) const {
        const BodyTag d;
        for (unsigned p = 0; p < Count; ++p)
            for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d))
                hn::Store(hn::Mul(hn::Load(d, rows.column[p].lane + lane), hn::Set(d, m_blocks.inversePivots[kBodyAxes * place + p])), d,
                          scaled.column[p].lane + lane);
    }

    // L D L' of a joint's own rows: L' in the place of the upper triangle.
    HWY_INLINE bool factorPivot(unsigned place, const double *before) {
        const unsigned rows = m_blocks.sizes[place];
        dxBodyBlock &block = m_blocks.diagonal[place];
        double *const inverses = m_blocks.inversePivots.data() + std::size_t(kBodyAxes) * place;
        for (unsigned r = 0; r < rows; ++r) {
            double *const row = block.column[r].lane;
            const double pivot = row[r];
            if (!(pivot > kMinPivot * before[r]) || !std::isfinite(pivot)) return false;
            inverses[r] = 1 / pivot;
            for (unsigned s = r + 1; s < rows; ++s) {
                const double factor = row[s] * inverses[r];
                for (unsigned k = s; k < rows; ++k) block.column[s].lane[k] -= factor * row[k];
            }
            for (unsigned s = r + 1; s < rows; ++s) row[s] *= inverses[r];
        }
        return true;
    }

    // inv(L) times the other columns of a joint's rows.
    template <class Row>
    HWY_INLINE void divideRows(unsigned place, unsigned width, Row row) const {
        const BodyTag d;
        const dxBodyBlock &factor = m_blocks.diagonal[place];
        const unsigned rows = m_blocks.sizes[place];
        for (unsigned lane = 0; lane < width; lane += hn::Lanes(d)) {
            hn::Vec<BodyTag> known[kBodyAxes];
            known[0] = hn::Load(d, row(0).lane + lane);
            for (unsigned s = 1; s < rows; ++s) {
                auto sum = hn::Load(d, row(s).lane + lane);
                for (unsigned r = 0; r < s; ++r) sum = hn::Sub(sum, hn::Mul(hn::Set(d, factor.column[r].lane[s]), known[r]));
                known[s] = sum;
                hn::Store(sum, d, row(s).lane + lane);
            }
        }
    }

    HWY_INLINE void reduceUnilateralRows(unsigned place) {
        withRows(m_blocks.sizes[place], [&](auto count) HWY_ATTR { reduceUnilateralRowsBy<decltype(count)::value>(place); });
    }

    // Rows of a line at a time: in each of them the columns up to the line.
    template <unsigned Count>
    HWY_INLINE void reduceUnilateralRowsBy(unsigned place) {
        const std::uint64_t lines = m_blocks.masks[place];
        for (std::uint64_t rowMask = lines; rowMask != 0;) {
            const unsigned rowLine = takeLowest(rowMask);
            dxBodyBlock own, factors;
            for (unsigned p = 0; p < Count; ++p) own.column[p] = m_blocks.besideOf(place, p)[rowLine];
            scaleRows<Count>(place, own, factors);
            const unsigned firstRow = rowLine * kBodyLanes, rows = HWY_MIN(kBodyLanes, m_blocks.unilateralCount + 1 - firstRow);
            for (std::uint64_t mask = lines & (~std::uint64_t(0) >> (63 - rowLine)); mask != 0;) {
                const unsigned line = takeLowest(mask);
                subtractProducts<Count>(
                    factors, rows, kBodyLanes, [&](unsigned p) -> const dxBodyVector & { return m_blocks.besideOf(place, p)[line]; },
                    [&](unsigned i) -> dxBodyVector & { return m_blocks.unilateralRow(firstRow + i)[line]; });
            }
        }
    }

    dxRowBlocks &m_blocks;
    const dxEliminationOrder &m_order;
};

bool eliminateRows(dxRowBlocks &blocks) { return RowElimination(blocks).eliminate(); }

class BackSubstitution {
public:
    BackSubstitution(const dxRowBlocks &blocks, const dxBodyVector *unilateralForces, dxBodyVectors &forces)
        : m_blocks(blocks), m_unilateralForces(unilateralForces), m_forces(forces) {}

    void substitute() {
        for (unsigned place = m_blocks.order.bodyCount(); place-- > 0;) substitute(place);
    }

private:
    HWY_INLINE void substitute(unsigned place) {
        withRows(m_blocks.sizes[place], [&](auto count) HWY_ATTR { findForces<decltype(count)::value>(place); });
    }

    template <unsigned Count>
    HWY_INLINE void findForces(unsigned place) {
        dxBodyBlock sums;
        addUpColumns<Count>(place, sums);
        const dxBodyBlock &factor = m_blocks.diagonal[place];
        double *const force = m_forces[place].lane;
        for (unsigned row = Count; row-- > 0;) {
            double sum = -addUp(sums.column[row].lane) * m_blocks.inversePivots[kBodyAxes * place + row];
            for (unsigned other = row + 1; other < Count; ++other) sum -= factor.column[row].lane[other] * force[other];
            force[row] = sum;
        }
    }

    // A joint's rows times the forces that are known, lane by lane.
    template <unsigned Count>
    HWY_INLINE void addUpColumns(unsigned place, dxBodyBlock &sums) const {
        const BodyTag d;
        for (unsigned lane = 0; lane < kBodyLanes; lane += hn::Lanes(d)) {
            hn::Vec<BodyTag> sum[Count];
            for (unsigned row = 0; row < Count; ++row) sum[row] = hn::Zero(d);
            for (std::uint64_t mask = m_blocks.masks[place]; mask != 0;) {
                const unsigned line = takeLowest(mask);
                const auto known = hn::Load(d, m_unilateralForces[line].lane + lane);
                for (unsigned row = 0; row < Count; ++row)
                    sum[row] = hn::Add(sum[row], hn::Mul(hn::Load(d, m_blocks.besideOf(place, row)[line].lane + lane), known));
            }
            for (unsigned block = m_blocks.order.firstBlock(place); block < m_blocks.order.firstBlock(place + 1); ++block) {
                const auto known = hn::Load(d, m_forces[m_blocks.order.rowOf(block)].lane + lane);
                for (unsigned row = 0; row < Count; ++row)
                    sum[row] = hn::Add(sum[row], hn::Mul(hn::Load(d, m_blocks.below[block].column[row].lane + lane), known));
            }
            for (unsigned row = 0; row < Count; ++row) hn::Store(sum[row], d, sums.column[row].lane + lane);
        }
    }

    const dxRowBlocks &m_blocks;
    const dxBodyVector *const m_unilateralForces;
    dxBodyVectors &m_forces;
};

void substituteBack(const dxRowBlocks &blocks, const dxBodyVector *unilateralForces, dxBodyVectors &forces) {
    BackSubstitution(blocks, unilateralForces, forces).substitute();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxFastStepKernels {
HWY_EXPORT(makeRowMatrix);
HWY_EXPORT(eliminateRows);
HWY_EXPORT(substituteBack);
}  // namespace dxFastStepKernels

void dxMakeRowMatrix(dxRowBlocks &blocks, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::makeRowMatrix)(blocks, inverseMasses, motions);
}

bool dxEliminateRows(dxRowBlocks &blocks) { return HWY_DYNAMIC_DISPATCH(dxFastStepKernels::eliminateRows)(blocks); }

void dxSubstituteBack(const dxRowBlocks &blocks, const dxBodyVector *unilateralForces, dxBodyVectors &forces) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::substituteBack)(blocks, unilateralForces, forces);
}
#endif
