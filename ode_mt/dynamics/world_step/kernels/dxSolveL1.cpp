#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxSolveL1.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/kernels/dxLanes-inl.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"
#include "dynamics/world_step/kernels/dxSolveL1Plain.h"
#include "dynamics/world_step/kernels/dxTriangle.h"
#include "threading/dxTaskRunner.h"
#include "threading/pool/dxOrderedCompletion.h"

// Forward substitution: lanes are rows; several of upstream's groups of four make a block, so that enough independent sums are in flight.
//
// Back substitution: lanes are results; a band of rows whose results are known adds its products to the sums of all results before it, and so L
// is read along its rows.
HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

// --- forward substitution ------------------------------------------------------------------------------------

constexpr std::size_t kWideBlock = 16, kNarrowBlock = 8;  // rows
// Below this many columns a wide block spends more in its own triangle than it saves in the columns.
constexpr std::size_t kWideBlockColumns = 32;

// sum[row] = the row's products with x over columns begin..end-1, both multiples of four
template <std::size_t Rows, unsigned Stride>
HWY_INLINE void sumColumns(const dReal *row, std::size_t rowSkip, const dReal *x, std::size_t begin,
                           std::size_t end, dReal *HWY_RESTRICT sum) {
    const RowLanes<Rows> d;
    constexpr std::size_t kVectors = Rows / kLanes<RowLanes<Rows>>;
    hn::Vec<RowLanes<Rows>> total[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) total[v] = hn::Zero(d);
    for (std::size_t column = begin; column < end; column += 4) {
        for (std::size_t v = 0; v < kVectors; ++v) {
            const auto tile = loadFourColumns(d, row + v * hn::Lanes(d) * rowSkip + column, rowSkip);
            for (std::size_t k = 0; k < 4; ++k) {
                const auto q = hn::Set(d, x[(column + k) * Stride]);
                total[v] = hn::Add(total[v], hn::Mul(tile.column[k], q));
            }
        }
    }
    for (std::size_t v = 0; v < kVectors; ++v) hn::StoreU(total[v], d, sum + v * hn::Lanes(d));
}

// sum[row] += the row's products with the four columns of `x`
HWY_INLINE void addGroup(const dReal *row, std::size_t rowSkip, std::size_t rows, const FourResults &x,
                         dReal *HWY_RESTRICT sum) {
    const RowLanes<4> d;
    for (std::size_t first = 0; first < rows; first += hn::Lanes(d)) {
        const auto tile = loadFourColumns(d, row + first * rowSkip, rowSkip);
        auto total = hn::LoadU(d, sum + first);
        for (std::size_t k = 0; k < 4; ++k)
            total = hn::Add(total, hn::Mul(tile.column[k], hn::Set(d, x.y[k])));
        hn::StoreU(total, d, sum + first);
    }
}

template <std::size_t Rows, unsigned Stride>
HWY_INLINE void solveBlock(const dReal *L, dReal *B, std::size_t firstRow, std::size_t rowSkip,
                           const dxSkyline &skyline) {
    HWY_ALIGN dReal sum[Rows];
    sumColumns<Rows, Stride>(L + firstRow * rowSkip, rowSkip, B, skyline.begin(firstRow, Rows, 4), firstRow, sum);
    const dReal *diagonal = L + firstRow * (rowSkip + 1);
    for (std::size_t group = 0; group < Rows; group += 4) {
        const dReal *corner = diagonal + group * (rowSkip + 1);
        const FourResults x =
            finishStraightGroup<Stride>(corner, rowSkip, B + (firstRow + group) * Stride, sum + group);
        addGroup(corner + 4 * rowSkip, rowSkip, Rows - group - 4, x, sum + group + 4);
    }
}

template <unsigned Stride>
HWY_INLINE void solveStraight(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip,
                              const dxSkyline &skyline) {
    std::size_t row = 0;
    const auto remain = [&](std::size_t rows) { return row + rows <= rowCount; };
    for (; row < kWideBlockColumns && remain(kNarrowBlock); row += kNarrowBlock)
        solveBlock<kNarrowBlock, Stride>(L, B, row, rowSkip, skyline);
    for (; remain(kWideBlock); row += kWideBlock) solveBlock<kWideBlock, Stride>(L, B, row, rowSkip, skyline);
    for (; remain(kNarrowBlock); row += kNarrowBlock)
        solveBlock<kNarrowBlock, Stride>(L, B, row, rowSkip, skyline);
    for (; remain(4); row += 4) solveBlock<4, Stride>(L, B, row, rowSkip, skyline);
    for (; row < rowCount; ++row) solveStraightSingle<Stride>(L + row * rowSkip, B, row);
}

void solveStraight1(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip,
                    const dxSkyline &skyline) {
    solveStraight<1>(L, B, rowCount, rowSkip, skyline);
}
void solveStraight2(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip) {
    solveStraight<2>(L, B, rowCount, rowSkip, dxSkyline());
}

// --- back substitution ---------------------------------------------------------------------------------------

constexpr std::size_t kBand = 8;     // rows: their results stay in registers
constexpr std::size_t kPanel = 512;  // columns: their sums stay in L1
constexpr std::size_t kMaxShortRows = 35;

// sum[column] += products of Count rows of L with their results x, the last row first; `offset`: of column 0 in a row
template <std::size_t Count, unsigned Stride, class D, class Rows>
HWY_INLINE std::size_t addBandWith(D d, const Rows &L, std::size_t firstRow, std::size_t offset, const dReal *B,
                                   std::size_t first, std::size_t columns, dReal *HWY_RESTRICT sum) {
    const dReal *row[Count];
    hn::Vec<D> q[Count];
    for (std::size_t r = 0; r < Count; ++r) {
        row[r] = L(firstRow + r) + offset;
        q[r] = hn::Set(d, B[(firstRow + r) * Stride]);
    }
    for (; first + hn::Lanes(d) <= columns; first += hn::Lanes(d)) {
        auto total = hn::Load(d, sum + first);
        for (std::size_t r = Count; r-- > 0;) total = hn::Add(total, hn::Mul(hn::LoadU(d, row[r] + first), q[r]));
        hn::Store(total, d, sum + first);
    }
    return first;
}

// As above with the widest vectors, of whose length `first` is a multiple; `columns`, a multiple of four, need not
// be one.
template <std::size_t Count, unsigned Stride, class Rows>
HWY_INLINE void addBand(const Rows &L, std::size_t firstRow, std::size_t offset, const dReal *B, std::size_t first,
                        std::size_t columns, dReal *HWY_RESTRICT sum) {
    const std::size_t done =
        addBandWith<Count, Stride>(hn::ScalableTag<dReal>(), L, firstRow, offset, B, first, columns, sum);
    if (done < columns) addBandWith<Count, Stride>(RowLanes<4>(), L, firstRow, offset, B, done, columns, sum);
}

// addBand for the one to three rows after the last group of four.
template <unsigned Stride, class Rows>
HWY_INLINE void addLastRows(const Rows &L, std::size_t firstRow, std::size_t offset, const dReal *B, std::size_t rows,
                            std::size_t columns, dReal *HWY_RESTRICT sum) {
    if (rows == 1) addBand<1, Stride>(L, firstRow, offset, B, 0, columns, sum);
    if (rows == 2) addBand<2, Stride>(L, firstRow, offset, B, 0, columns, sum);
    if (rows == 3) addBand<3, Stride>(L, firstRow, offset, B, 0, columns, sum);
}

// Results after a panel are all known, ...
struct AllKnown {
    HWY_INLINE void await(std::size_t /*row*/) const {}
};

// ... or other workers are finding them, a panel each.
class KnownInOrder {
public:
    KnownInOrder(const dxOrderedCompletion &completion, std::size_t lastGroupEnd) : m_completion(completion), m_lastGroupEnd(lastGroupEnd) {}

    // The results of `row` and all after it.
    HWY_INLINE void await(std::size_t row) {
        const auto needed = static_cast<unsigned>((m_lastGroupEnd - row + kSharedPanel - 1) / kSharedPanel);
        if (m_finished < needed) m_finished = m_completion.await(needed);
    }

private:
    const dxOrderedCompletion &m_completion;
    const std::size_t m_lastGroupEnd;
    unsigned m_finished = 0;
};

// The results of columns begin..end-1, at most kPanel and a multiple of four, from those after them.
template <unsigned Stride, bool SkipsZeros, class Rows, class Known>
HWY_INLINE void solvePanel(const Rows &L, dReal *B, std::size_t begin, std::size_t end, std::size_t rowCount,
                           const dxSkyline &skyline, Known known) {
    HWY_ALIGN dReal sum[kPanel];
    const RowLanes<4> d;
    const hn::ScalableTag<dReal> widest;
    for (std::size_t column = 0; column < end - begin; column += hn::Lanes(d))
        hn::Store(hn::Zero(d), d, sum + column);
    const auto addBandAt = [&](std::size_t row, std::size_t columns) {
        std::size_t skipped = 0;
        if constexpr (SkipsZeros) {
            const std::size_t first = skyline.begin(row, kBand);
            if (first >= begin + columns) return;
            skipped = first > begin ? (first - begin) & ~(hn::Lanes(widest) - 1) : 0;
        }
        addBand<kBand, Stride>(L, row, begin, B, skipped, columns, sum);
    };

    const std::size_t lastRows = rowCount % 4, lastGroupEnd = rowCount - lastRows;
    addLastRows<Stride>(L, lastGroupEnd, begin, B, lastRows, end - begin, sum);
    for (std::size_t row = lastGroupEnd; row > end;) {
        row -= kBand;
        known.await(row);
        addBandAt(row, end - begin);
    }
    for (std::size_t row = end; row > begin;) {
        row -= 4;
        finishTransposedGroup<Stride>(L, row, B, sum + (row - begin));
        if (row - begin >= 4) {
            const std::size_t next = row - 4;
            addBandWith<4, Stride>(RowLanes<4>(), L, row, next, B, 0, 4, sum + (next - begin));
            row = next;
            finishTransposedGroup<Stride>(L, row, B, sum + (row - begin));
            addBandAt(row, row - begin);
        }
    }
}

// Few rows: the sums of all groups stay in registers, and no loop goes over groups, whose end could be guessed wrong. A
// group is solved, its four results are multiplied into the sums before it, and what is left is the same problem with one
// group less.
template <unsigned Stride, class Rows>
class ShortSolve {
public:
    HWY_INLINE ShortSolve(const Rows &L, dReal *B) : m_L(L), m_B(B) {
        for (Sum &sum : m_sums)
            for (Lanes &lanes : sum.part) lanes = hn::Zero(RowLanes<4>());
    }

    HWY_INLINE void solve(std::size_t rowCount) {
        const std::size_t groups = rowCount / 4, first = 4 * groups;
        finishTransposedLast<Stride>(m_L, first, m_B, rowCount);
        for (std::size_t row = rowCount; row-- > first;) addRow(groups, m_L(row), m_B[row * Stride]);
        solveGroups(groups);
    }

private:
    using Lanes = hn::Vec<RowLanes<4>>;
    static constexpr std::size_t kMaxGroups = kMaxShortRows / 4, kParts = 4 / kLanes<RowLanes<4>>;
    static_assert(kMaxGroups == 8, "addRow and solveGroups begin with eight");
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
        const FourResults results = finishTransposedGroup<Stride>(m_L, 4 * Group, m_B, sum);
        for (std::size_t row = 4; row-- > 0;) addRow(Group, m_L(4 * Group + row), results.y[row]);
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

    const Rows &m_L;
    dReal *const m_B;
    Sum m_sums[kMaxGroups];
};

template <unsigned Stride, bool SkipsZeros, class Rows>
HWY_INLINE void solveInPanels(const Rows &L, dReal *B, std::size_t rowCount, const dxSkyline &skyline) {
    std::size_t end = rowCount - rowCount % 4;
    finishTransposedLast<Stride>(L, end, B, rowCount);
    while (end > 0) {
        const std::size_t begin = end > kPanel ? end - kPanel : 0;
        solvePanel<Stride, SkipsZeros>(L, B, begin, end, rowCount, skyline, AllKnown());
        end = begin;
    }
}

template <unsigned Stride, class Rows>
HWY_INLINE void solveTransposed(const Rows &L, dReal *B, std::size_t rowCount) {
    if (rowCount <= kMaxShortRows)
        ShortSolve<Stride, Rows>(L, B).solve(rowCount);
    else
        solveInPanels<Stride, false>(L, B, rowCount, dxSkyline());
}

void solveTransposed1(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip) {
    solveTransposed<1>(dxRowsApart(L, rowSkip), B, rowCount);
}
void solveTransposed2(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip) {
    solveTransposed<2>(dxRowsApart(L, rowSkip), B, rowCount);
}
void solveTransposedListed(const dReal *const *L, dReal *B, std::size_t rowCount, const dxSkyline &skyline) {
    const dxListedRows rows(L);
    if (skyline.skipsZeros() && rowCount > kMaxShortRows)
        solveInPanels<1, true>(rows, B, rowCount, skyline);
    else
        solveTransposed<1>(rows, B, rowCount);
}

// Solves the panel with number `turn`, counted from the last columns.
void solveTransposedOrdered(const dReal *const *L, dReal *B, std::size_t rowCount, const dxSkyline &skyline,
                           unsigned chunk, dxOrderedCompletion &completion) {
    const std::size_t lastGroupEnd = rowCount - rowCount % 4, end = lastGroupEnd - chunk * kSharedPanel;
    const std::size_t begin = end > kSharedPanel ? end - kSharedPanel : 0;
    const KnownInOrder known(completion, lastGroupEnd);
    if (skyline.skipsZeros())
        solvePanel<1, true>(dxListedRows(L), B, begin, end, rowCount, skyline, known);
    else
        solvePanel<1, false>(dxListedRows(L), B, begin, end, rowCount, skyline, known);
    completion.finish(chunk);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(solveStraight1);
HWY_EXPORT(solveStraight2);
HWY_EXPORT(solveTransposed1);
HWY_EXPORT(solveTransposed2);
HWY_EXPORT(solveTransposedListed);
HWY_EXPORT(solveTransposedOrdered);

// Up to this many rows vectors do not pay.
constexpr unsigned kPlainForwardRows = 15, kPlainBackRows = 11;
}  // namespace dxSolve

void dxSolveL1Straight(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip, const dxSkyline &skyline) {
    using namespace dxSolve;
    if (rowCount <= kPlainForwardRows) return solveStraightPlain<1>(L, B, rowCount, rowSkip);
    HWY_DYNAMIC_DISPATCH(solveStraight1)(L, B, rowCount, rowSkip, skyline);
}

template <>
void dxSolveL1Straight<1>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    dxSolveL1Straight(L, B, rowCount, rowSkip, dxSkyline());
}

template <>
void dxSolveL1Straight<2>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    using namespace dxSolve;
    if (rowCount <= kPlainForwardRows) return solveStraightPlain<2>(L, B, rowCount, rowSkip);
    HWY_DYNAMIC_DISPATCH(solveStraight2)(L, B, rowCount, rowSkip);
}

template <>
void dxSolveL1Transposed<1>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    using namespace dxSolve;
    if (rowCount <= kPlainBackRows) return solveTransposedPlain<1>(dxRowsApart(L, rowSkip), B, rowCount);
    HWY_DYNAMIC_DISPATCH(solveTransposed1)(L, B, rowCount, rowSkip);
}

template <>
void dxSolveL1Transposed<2>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    using namespace dxSolve;
    if (rowCount <= kPlainBackRows) return solveTransposedPlain<2>(dxRowsApart(L, rowSkip), B, rowCount);
    HWY_DYNAMIC_DISPATCH(solveTransposed2)(L, B, rowCount, rowSkip);
}

void dxSolveL1Transposed(const dReal *const *L, dReal *B, unsigned rowCount, const dxSkyline &skyline,
                         dxTaskRunner *runner) {
    using namespace dxSolve;
    if (rowCount <= kPlainBackRows) return solveTransposedPlain<1>(dxListedRows(L), B, rowCount);
    if (runner == nullptr) return HWY_DYNAMIC_DISPATCH(solveTransposedListed)(L, B, rowCount, skyline);
    const std::size_t lastGroupEnd = rowCount - rowCount % 4;
    finishTransposedLast<1>(dxListedRows(L), lastGroupEnd, B, rowCount);
    dxOrderedCompletion completion;
    runner->forBlocks(dxParallelStage::TransposedSolve, static_cast<unsigned>((lastGroupEnd + kSharedPanel - 1) / kSharedPanel),
        [&](unsigned chunk, unsigned) {
        HWY_DYNAMIC_DISPATCH(solveTransposedOrdered)(L, B, rowCount, skyline, chunk, completion);
    });
}
#endif
