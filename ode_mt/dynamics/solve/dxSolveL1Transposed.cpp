#include "simd/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/solve/dxSolveL1Transposed.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/solve/dxRowTile-inl.h"
#include "dynamics/solve/dxSolveL1.h"
#include "dynamics/solve/dxSolveL1Plain.h"

// Lanes are results: a band of rows whose results are known adds its products to the sums of all results
// before it, and so L is read along its rows.
HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

constexpr std::size_t kBand = 8;     // rows: their results stay in registers
constexpr std::size_t kPanel = 512;  // columns: their sums stay in the first cache

// sum[column] += products of Rows rows of L with their results x, the last row first
template <std::size_t Rows, unsigned Stride, class D>
HWY_INLINE std::size_t addBandWith(D d, const dReal *row, std::size_t rowSkip, const dReal *x,
                                   std::size_t first, std::size_t columns, dReal *HWY_RESTRICT sum) {
    hn::Vec<D> q[Rows];
    for (std::size_t r = 0; r < Rows; ++r) q[r] = hn::Set(d, x[r * Stride]);
    for (; first + hn::Lanes(d) <= columns; first += hn::Lanes(d)) {
        auto total = hn::Load(d, sum + first);
        for (std::size_t r = Rows; r-- > 0;) {
            total = hn::Add(total, hn::Mul(hn::LoadU(d, row + r * rowSkip + first), q[r]));
        }
        hn::Store(total, d, sum + first);
    }
    return first;
}

// As above with the widest vectors, of whose length `first` is a multiple; `columns`, a multiple of four, need not
// be one.
template <std::size_t Rows, unsigned Stride>
HWY_INLINE void addBand(const dReal *row, std::size_t rowSkip, const dReal *x, std::size_t first,
                        std::size_t columns, dReal *HWY_RESTRICT sum) {
    const std::size_t done =
        addBandWith<Rows, Stride>(hn::ScalableTag<dReal>(), row, rowSkip, x, first, columns, sum);
    if (done < columns) addBandWith<Rows, Stride>(RowLanes<4>(), row, rowSkip, x, done, columns, sum);
}

// addBand for the one to three rows after the last group of four.
template <unsigned Stride>
HWY_INLINE void addLastRows(const dReal *row, std::size_t rowSkip, const dReal *x, std::size_t rows,
                            std::size_t columns, dReal *HWY_RESTRICT sum) {
    if (rows == 1) addBand<1, Stride>(row, rowSkip, x, 0, columns, sum);
    if (rows == 2) addBand<2, Stride>(row, rowSkip, x, 0, columns, sum);
    if (rows == 3) addBand<3, Stride>(row, rowSkip, x, 0, columns, sum);
}

// The results of columns begin..end-1, at most kPanel and a multiple of four, when all after them are known.
template <unsigned Stride, bool LeavesOut>
HWY_INLINE void solvePanel(const dReal *L, dReal *B, std::size_t begin, std::size_t end, std::size_t rowCount,
                           std::size_t rowSkip, const dxEnvelope &envelope) {
    HWY_ALIGN dReal sum[kPanel];
    const RowLanes<4> d;
    const hn::ScalableTag<dReal> widest;
    for (std::size_t column = 0; column < end - begin; column += hn::Lanes(d))
        hn::Store(hn::Zero(d), d, sum + column);
    const auto element = [&](std::size_t row, std::size_t column) { return L + row * rowSkip + column; };
    const auto addBandAt = [&](std::size_t row, std::size_t columns) {
        std::size_t leftOut = 0;
        if constexpr (LeavesOut) {
            const std::size_t first = envelope.begin(row, kBand);
            if (first >= begin + columns) return;
            leftOut = first > begin ? (first - begin) & ~(hn::Lanes(widest) - 1) : 0;
        }
        addBand<kBand, Stride>(element(row, begin), rowSkip, B + row * Stride, leftOut, columns, sum);
    };

    const std::size_t lastRows = rowCount % 4, lastGroupEnd = rowCount - lastRows;
    addLastRows<Stride>(element(lastGroupEnd, begin), rowSkip, B + lastGroupEnd * Stride, lastRows,
                        end - begin, sum);
    for (std::size_t row = lastGroupEnd; row > end;) {
        row -= kBand;
        addBandAt(row, end - begin);
    }
    for (std::size_t row = end; row > begin;) {
        row -= 4;
        finishTransposedGroup<Stride>(element(row, row), rowSkip, B + row * Stride, sum + (row - begin));
        if (row - begin >= 4) {
            const std::size_t next = row - 4;
            addBandWith<4, Stride>(RowLanes<4>(), element(row, next), rowSkip, B + row * Stride, 0, 4,
                                   sum + (next - begin));
            row = next;
            finishTransposedGroup<Stride>(element(row, row), rowSkip, B + row * Stride, sum + (row - begin));
            addBandAt(row, row - begin);
        }
    }
}

// Few rows: the sums of all groups stay in registers, and no loop goes over groups, whose end could be guessed wrong. A
// group is solved, its four results are multiplied into the sums before it, and what is left is the same problem with one
// group less.
template <unsigned Stride>
class ShortSolve {
public:
    HWY_INLINE ShortSolve(const dReal *L, dReal *B, std::size_t rowSkip) : m_L(L), m_B(B), m_rowSkip(rowSkip) {
        for (Sum &sum : m_sums)
            for (Lanes &lanes : sum.part) lanes = hn::Zero(RowLanes<4>());
    }

    HWY_INLINE void solve(std::size_t rowCount) {
        const std::size_t groups = rowCount / 4, lastRows = rowCount % 4, first = 4 * groups;
        finishTransposedLast<Stride>(m_L + first * (m_rowSkip + 1), m_rowSkip, m_B + first * Stride, lastRows);
        for (std::size_t row = rowCount; row-- > first;) addRow(groups, m_L + row * m_rowSkip, m_B[row * Stride]);
        solveGroups(groups);
    }

    static constexpr std::size_t kMostRows = 35;

private:
    using Lanes = hn::Vec<RowLanes<4>>;
    static constexpr std::size_t kMostGroups = kMostRows / 4, kParts = 4 / kLanes<RowLanes<4>>;
    static_assert(kMostGroups == 8, "addRow and solveGroups begin with eight");
    struct Sum {
        Lanes part[kParts];
    };

    template <std::size_t Group>
    HWY_INLINE void add(const dReal *row, dReal x) {
        const RowLanes<4> d;
        for (std::size_t part = 0; part < kParts; ++part) {
            Lanes &sum = m_sums[Group].part[part];
            sum = hn::Add(sum, hn::Mul(hn::LoadU(d, row + 4 * Group + part * hn::Lanes(d)), hn::Set(d, x)));
        }
    }

    // Into the sums of the first `groups` groups.
    HWY_INLINE void addRow(std::size_t groups, const dReal *row, dReal x) {
        switch (groups) {
        case 8: add<7>(row, x); [[fallthrough]];
        case 7: add<6>(row, x); [[fallthrough]];
        case 6: add<5>(row, x); [[fallthrough]];
        case 5: add<4>(row, x); [[fallthrough]];
        case 4: add<3>(row, x); [[fallthrough]];
        case 3: add<2>(row, x); [[fallthrough]];
        case 2: add<1>(row, x); [[fallthrough]];
        case 1: add<0>(row, x);
        }
    }

    template <std::size_t Group>
    HWY_INLINE void solveGroup() {
        const RowLanes<4> d;
        HWY_ALIGN dReal sum[4];
        for (std::size_t part = 0; part < kParts; ++part)
            hn::Store(m_sums[Group].part[part], d, sum + part * hn::Lanes(d));
        const dReal *const rows = m_L + 4 * Group * m_rowSkip;
        const FourResults results =
            finishTransposedGroup<Stride>(rows + 4 * Group, m_rowSkip, m_B + 4 * Group * Stride, sum);
        for (std::size_t row = 4; row-- > 0;) addRow(Group, rows + row * m_rowSkip, results.y[row]);
    }

    HWY_INLINE void solveGroups(std::size_t groups) {
        switch (groups) {
        case 8: solveGroup<7>(); [[fallthrough]];
        case 7: solveGroup<6>(); [[fallthrough]];
        case 6: solveGroup<5>(); [[fallthrough]];
        case 5: solveGroup<4>(); [[fallthrough]];
        case 4: solveGroup<3>(); [[fallthrough]];
        case 3: solveGroup<2>(); [[fallthrough]];
        case 2: solveGroup<1>(); [[fallthrough]];
        case 1: solveGroup<0>();
        }
    }

    const dReal *const m_L;
    dReal *const m_B;
    const std::size_t m_rowSkip;
    Sum m_sums[kMostGroups];
};

template <unsigned Stride, bool LeavesOut>
HWY_INLINE void solveTransposed(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip,
                                const dxEnvelope &envelope) {
    const std::size_t lastRows = rowCount % 4;
    std::size_t end = rowCount - lastRows;
    finishTransposedLast<Stride>(L + end * (rowSkip + 1), rowSkip, B + end * Stride, lastRows);
    while (end > 0) {
        const std::size_t begin = end > kPanel ? end - kPanel : 0;
        solvePanel<Stride, LeavesOut>(L, B, begin, end, rowCount, rowSkip, envelope);
        end = begin;
    }
}

void solveTransposed1(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip,
                      const dxEnvelope &envelope) {
    if (rowCount <= ShortSolve<1>::kMostRows) {
        ShortSolve<1>(L, B, rowSkip).solve(rowCount);
    } else if (envelope.leavesOut()) {
        solveTransposed<1, true>(L, B, rowCount, rowSkip, envelope);
    } else {
        solveTransposed<1, false>(L, B, rowCount, rowSkip, envelope);
    }
}
void solveTransposed2(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip) {
    if (rowCount <= ShortSolve<2>::kMostRows) {
        ShortSolve<2>(L, B, rowSkip).solve(rowCount);
    } else {
        solveTransposed<2, false>(L, B, rowCount, rowSkip, dxEnvelope());
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(solveTransposed1);
HWY_EXPORT(solveTransposed2);

// Up to this many rows vectors do not pay.
constexpr unsigned kPlainRows = 11;
}  // namespace dxSolve

void dxSolveL1Transposed(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip,
                         const dxEnvelope &envelope) {
    using namespace dxSolve;
    if (rowCount <= kPlainRows) return solveTransposedPlain<1>(L, B, rowCount, rowSkip);
    HWY_DYNAMIC_DISPATCH(solveTransposed1)(L, B, rowCount, rowSkip, envelope);
}

template <>
void dxSolveL1Transposed<1>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    dxSolveL1Transposed(L, B, rowCount, rowSkip, dxEnvelope());
}

template <>
void dxSolveL1Transposed<2>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    using namespace dxSolve;
    if (rowCount <= kPlainRows) return solveTransposedPlain<2>(L, B, rowCount, rowSkip);
    HWY_DYNAMIC_DISPATCH(solveTransposed2)(L, B, rowCount, rowSkip);
}
#endif
