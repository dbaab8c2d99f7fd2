#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxRowElimination.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"
#include "dynamics/world_step/fast/dxRowElimination.h"

#include <cmath>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace dxDirect {
namespace HWY_NAMESPACE {

// A pivot below this part of the diagonal's element is rounding: sums of a dozen rows leave less than 1e-14 of it.
constexpr double kMinPivot = 1e-11;

// The position of the lowest bit, which is removed.
HWY_INLINE unsigned takeLowest(std::uint64_t &mask) {
    const unsigned lowest = hwy::Num0BitsBelowLS1Bit_Nonzero64(mask);
    mask &= mask - 1;
    return lowest;
}

// Calls work(count), a joint's number of rows being a constant in it, so that loops over rows are unrolled.
template <class Work>
HWY_INLINE void withRows(unsigned rows, const Work &work) {
    switch (rows) {
        case 1: return work(std::integral_constant<unsigned, 1>());
        case 2: return work(std::integral_constant<unsigned, 2>());
        case 3: return work(std::integral_constant<unsigned, 3>());
        case 4: return work(std::integral_constant<unsigned, 4>());
        case 5: return work(std::integral_constant<unsigned, 5>());
        default: return work(std::integral_constant<unsigned, kBodyAxes>());
    }
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
        for (unsigned place = 0; place < m_order.bodyCount() && m_blocks.limited > 0; ++place) reduceLimitedRows(place);
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

    HWY_INLINE void reduceLimitedRows(unsigned place) {
        withRows(m_blocks.sizes[place], [&](auto count) HWY_ATTR { reduceLimitedRowsBy<decltype(count)::value>(place); });
    }

    // Rows of a line at a time: in each of them the columns up to the line.
    template <unsigned Count>
    HWY_INLINE void reduceLimitedRowsBy(unsigned place) {
        const std::uint64_t lines = m_blocks.masks[place];
        for (std::uint64_t rowMask = lines; rowMask != 0;) {
            const unsigned rowLine = takeLowest(rowMask);
            dxBodyBlock own, factors;
            for (unsigned p = 0; p < Count; ++p) own.column[p] = m_blocks.besideOf(place, p)[rowLine];
            scaleRows<Count>(place, own, factors);
            const unsigned firstRow = rowLine * kBodyLanes, rows = HWY_MIN(kBodyLanes, m_blocks.limited + 1 - firstRow);
            for (std::uint64_t mask = lines & (~std::uint64_t(0) >> (63 - rowLine)); mask != 0;) {
                const unsigned line = takeLowest(mask);
                subtractProducts<Count>(
                    factors, rows, kBodyLanes, [&](unsigned p) -> const dxBodyVector & { return m_blocks.besideOf(place, p)[line]; },
                    [&](unsigned i) -> dxBodyVector & { return m_blocks.limitedRow(firstRow + i)[line]; });
            }
        }
    }

    dxRowBlocks &m_blocks;
    const dxEliminationOrder &m_order;
};

bool eliminateRows(dxRowBlocks &blocks) { return RowElimination(blocks).eliminate(); }

class BackSubstitution {
public:
    BackSubstitution(const dxRowBlocks &blocks, const dxBodyVector *limited, dxBodyVectors &forces)
        : m_blocks(blocks), m_limited(limited), m_forces(forces) {}

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
                const auto known = hn::Load(d, m_limited[line].lane + lane);
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
    const dxBodyVector *const m_limited;
    dxBodyVectors &m_forces;
};

void substituteBack(const dxRowBlocks &blocks, const dxBodyVector *limited, dxBodyVectors &forces) {
    BackSubstitution(blocks, limited, forces).substitute();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxDirect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxDirect {
HWY_EXPORT(eliminateRows);
HWY_EXPORT(substituteBack);
}  // namespace dxDirect

bool dxEliminateRows(dxRowBlocks &blocks) { return HWY_DYNAMIC_DISPATCH(dxDirect::eliminateRows)(blocks); }

void dxSubstituteBack(const dxRowBlocks &blocks, const dxBodyVector *limited, dxBodyVectors &forces) {
    HWY_DYNAMIC_DISPATCH(dxDirect::substituteBack)(blocks, limited, forces);
}
#endif
