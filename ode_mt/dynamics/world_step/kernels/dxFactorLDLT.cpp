#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxFactorLDLT.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <algorithm>

#include "dynamics/world_step/kernels/dxFactorLDLT.h"
#include "dynamics/world_step/kernels/dxLanes-inl.h"

// Rows are factorised in panels, a row a lane. A row of L is a forward solve with the rows before it, scaled
// by d; upstream takes rows in pairs, and columns too: a result subtracts the sum of its products with the
// columns before its pair, added up from +0 in order, and then that with the first of the pair.
HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

// A panel of at most kLineLanes rows, from row `first` on.
struct FactorPanel {
    dReal *A, *d;
    std::size_t rowSkip;
    std::size_t first, rows;
    const dxSkyline &skyline;
    std::size_t begin;  // of the panel's skyline: nothing is done for the columns before it, a multiple of eight
    dReal *solved;   // L^-1 A, by column, then by lane
    dReal *squares;  // by lane: the sum of products of a row's solved elements with its scaled ones
    dReal *crosses;  // by lane, for the second row of a pair: with the scaled ones of the first

    dReal *row(std::size_t index) const { return A + index * rowSkip; }
    dReal *column(std::size_t index) const { return solved + index * kLineLanes; }
};

// Columns `pair` and `pair` + 1, whose right-hand sides lie where their results go.
HWY_INLINE void finishFactorPair(const FactorPanel &panel, std::size_t lane, std::size_t pair,
                                 const LineVector *sum) {
    const LineTag d;
    dReal *column0 = panel.column(pair) + lane, *column1 = panel.column(pair + 1) + lane;
    const auto y0 = hn::Sub(hn::Load(d, column0), sum[0]);
    const auto factor = hn::Set(d, panel.row(pair + 1)[pair]);
    const auto y1 = hn::Sub(hn::Sub(hn::Load(d, column1), sum[1]), hn::Mul(factor, y0));
    hn::Store(y0, d, column0);
    hn::Store(y1, d, column1);
}

// Columns first..first+Rows-1 of the panel.
template <std::size_t Rows>
HWY_INLINE void solveFactorColumns(const FactorPanel &panel, std::size_t first) {
    const LineTag d;
    const dxRowsApart triangle(panel.A, panel.rowSkip);
    for (std::size_t lane = 0; lane < kLineLanes; lane += hn::Lanes(d)) {
        LineVector sum[Rows];
        for (std::size_t r = 0; r < Rows; ++r) sum[r] = hn::Zero(d);
        const std::size_t begin = std::max(panel.begin, panel.skyline.begin(first, Rows));
        addColumns<Rows>(triangle, first, panel.solved + lane, begin, first, sum);
        finishFactorPair(panel, lane, first, sum);
        if constexpr (Rows > 2) {
            addColumns<Rows - 2>(triangle, first + 2, panel.solved + lane, first, first + 2,
                                 sum + 2);
            finishFactorPair(panel, lane, first + 2, sum + 2);
        }
        if constexpr (Rows > 4) {
            addColumns<Rows - 4>(triangle, first + 4, panel.solved + lane, first + 2,
                                 first + 4, sum + 4);
            finishFactorPair(panel, lane, first + 4, sum + 4);
            addColumns<Rows - 6>(triangle, first + 6, panel.solved + lane, first + 4,
                                 first + 6, sum + 6);
            finishFactorPair(panel, lane, first + 6, sum + 6);
        }
    }
}

// The panel's elements of a column; lanes whose rows end before it have zeros.
HWY_INLINE void loadFactorColumn(const FactorPanel &panel, std::size_t column) {
    dReal *lanes = panel.column(column);
    for (std::size_t lane = 0; lane < kLineLanes; ++lane) {
        const std::size_t row = panel.first + lane;
        lanes[lane] = lane < panel.rows && row > column ? panel.row(row)[column] : 0;
    }
}

// Adds columns begin..end-1 to the sums, and writes their rows of L from lane `from` on.
HWY_INLINE void scaleFactorColumns(const FactorPanel &panel, std::size_t begin, std::size_t end,
                                   std::size_t from) {
    const LineTag d;
    HWY_ALIGN dReal scaled[kLineLanes];
    for (std::size_t column = begin; column < end; ++column) {
        const auto factor = hn::Set(d, panel.d[column]);
        for (std::size_t lane = 0; lane < kLineLanes; lane += hn::Lanes(d)) {
            const auto y = hn::Load(d, panel.column(column) + lane);
            const auto q = hn::Mul(y, factor);
            hn::Store(q, d, scaled + lane);
            hn::Store(hn::Add(hn::Load(d, panel.squares + lane), hn::Mul(y, q)), d, panel.squares + lane);
        }
        for (std::size_t lane = 1; lane < kLineLanes; lane += 2)
            panel.crosses[lane] += panel.column(column)[lane] * scaled[lane - 1];
        for (std::size_t lane = from; lane < panel.rows; ++lane)
            panel.row(panel.first + lane)[column] = scaled[lane];
    }
}

// The two rows from `first` on, whose columns before them are known.
HWY_INLINE void finishFactorRows(const FactorPanel &panel, std::size_t first) {
    const std::size_t lane = first - panel.first;
    dReal *row0 = panel.row(first), *row1 = panel.row(first + 1);
    const dReal y00 = row0[first] - panel.squares[lane];
    const dReal y10 = row1[first] - panel.crosses[lane + 1];
    const dReal y11 = row1[first + 1] - panel.squares[lane + 1];
    panel.d[first] = 1 / y00;
    row1[first] = y10 * panel.d[first];
    panel.d[first + 1] = 1 / (y11 - y10 * row1[first]);
}

// The last of an odd number of rows has two sums, of the even and of the odd columns.
HWY_INLINE void finishLastFactorRow(const FactorPanel &panel, std::size_t last) {
    dReal *row = panel.row(last), even = 0, odd = 0;
    for (std::size_t column = panel.begin; column < last; column += 2) {
        const dReal y0 = panel.column(column)[last - panel.first],
                    y1 = panel.column(column + 1)[last - panel.first];
        row[column] = y0 * panel.d[column];
        row[column + 1] = y1 * panel.d[column + 1];
        even += y0 * row[column];
        odd += y1 * row[column + 1];
    }
    panel.d[last] = 1 / (row[last] - (even + odd));
}

HWY_INLINE void factorPanel(const FactorPanel &panel) {
    const std::size_t end = panel.first + panel.rows;
    for (std::size_t column = panel.begin; column + 1 < end; ++column) loadFactorColumn(panel, column);
    for (std::size_t column = panel.begin; column < panel.first; column += 8) solveFactorColumns<8>(panel, column);
    scaleFactorColumns(panel, panel.begin, panel.first, 0);
    for (std::size_t row = panel.first; row < end; row += 2) {
        if (row > panel.first) {
            solveFactorColumns<2>(panel, row - 2);
            scaleFactorColumns(panel, row - 2, row, row - panel.first);
        }
        if (row + 1 < end) {
            finishFactorRows(panel, row);
        } else {
            finishLastFactorRow(panel, row);
        }
    }
}

// The zeros before the skyline are scaled, too: they keep their signs unless a d is negative.
HWY_INLINE void signZeros(const FactorPanel &panel) {
    for (std::size_t column = 0; column < panel.begin; ++column)
        for (std::size_t lane = 0; lane < panel.rows; ++lane) panel.row(panel.first + lane)[column] *= panel.d[column];
}

void factorLDLT(dReal *A, dReal *d, std::size_t rowCount, std::size_t rowSkip, const dxSkyline &skyline,
                dReal *storage) {
    HWY_ALIGN dReal squares[kLineLanes], crosses[kLineLanes];
    bool areAllPositive = true;  // of d
    for (std::size_t first = 0; first < rowCount; first += kLineLanes) {
        std::fill_n(squares, kLineLanes, dReal(0));
        std::fill_n(crosses, kLineLanes, dReal(0));
        const std::size_t rows = std::min<std::size_t>(kLineLanes, rowCount - first);
        const FactorPanel panel = {A,    d, rowSkip, first, rows, skyline, skyline.begin(first, rows, 8), storage,
                                   squares, crosses};
        if (!areAllPositive) signZeros(panel);
        factorPanel(panel);
        areAllPositive = areAllPositive && std::all_of(d + first, d + first + rows, [](dReal x) { return x > 0; });
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(factorLDLT);
}  // namespace dxSolve

std::size_t dxFactorLDLTStorage(unsigned n) { return std::size_t(kLineLanes) * n; }

void dxFactorLDLT(dReal *A, dReal *d, unsigned rowCount, unsigned rowSkip, const dxSkyline &skyline,
                  dReal *storage) {
    HWY_DYNAMIC_DISPATCH(dxSolve::factorLDLT)(A, d, rowCount, rowSkip, skyline, storage);
}
#endif
