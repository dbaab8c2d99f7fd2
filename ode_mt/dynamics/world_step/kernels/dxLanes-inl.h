// The vectors of the exact step's kernels, and what several of them do with those: rows of a row-major matrix as columns in registers, and sums
// over a cache line of lanes. Included once per instruction set; the guard is Highway's.
#if defined(ODE_MT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ODE_MT_LANES_INL_H
#undef ODE_MT_LANES_INL_H
#else
#define ODE_MT_LANES_INL_H
#endif

#include <hwy/highway.h>
#include <ode/common.h>

#include <cstddef>

#include "core/dxCacheLine.h"
#include "dynamics/world_step/kernels/dxTriangle.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A vector of at most Rows lanes, of which Rows is a multiple.
template <std::size_t Rows>
using RowLanes = hn::CappedTag<dReal, Rows>;

template <class D>
constexpr std::size_t kLanes = hn::MaxLanes(D());

// A vector of a cache line of lanes, or a part of one.
using LineTag = RowLanes<kLineLanes>;
using LineVector = hn::Vec<LineTag>;

// sum[r] += L(firstRow + r, column) * y(column) for a vector of lanes, columns begin..end-1 in this order. `y`: a
// line of lanes for each column, from the vector's first lane on.
template <std::size_t Count, class Rows>
HWY_INLINE void addColumns(const Rows &L, std::size_t firstRow, const dReal *y, std::size_t begin, std::size_t end,
                           LineVector *sum) {
    const LineTag d;
    const dReal *row[Count];
    for (std::size_t r = 0; r < Count; ++r) row[r] = L(firstRow + r);
    for (std::size_t column = begin; column < end; ++column) {
        const auto lanes = hn::Load(d, y + column * kLineLanes);
        for (std::size_t r = 0; r < Count; ++r)
            sum[r] = hn::Add(sum[r], hn::Mul(hn::Set(d, row[r][column]), lanes));
    }
}

// Columns 0..3 of as many rows as D has lanes.
template <class D>
struct FourColumns {
    hn::Vec<D> column[4];
};

#if HWY_TARGET == HWY_SCALAR

template <class D>
HWY_INLINE FourColumns<D> loadFourColumns(D d, const dReal *row, std::size_t /*rowSkip*/) {
    return {{hn::LoadU(d, row), hn::LoadU(d, row + 1), hn::LoadU(d, row + 2), hn::LoadU(d, row + 3)}};
}

#else

constexpr std::size_t kPiece = 16 / sizeof(dReal);  // elements of 128 bits

// 128 bits of every kPiece-th row from `row` on, one row above the other.
template <class D>
HWY_INLINE hn::Vec<D> loadPieces(D d, const dReal *row, std::size_t rowSkip) {
    if constexpr (kLanes<D> <= kPiece) {
        return hn::LoadU(d, row);
    } else {
        const hn::Half<D> half;
        const auto lower = loadPieces(half, row, rowSkip);
        const auto upper = loadPieces(half, row + kLanes<decltype(half)> * rowSkip, rowSkip);
        return hn::Combine(d, upper, lower);
    }
}

template <class D, hwy::EnableIf<sizeof(hn::TFromD<D>) == 8> * = nullptr>
HWY_INLINE FourColumns<D> loadFourColumns(D d, const dReal *row, std::size_t rowSkip) {
    const auto even01 = loadPieces(d, row, rowSkip), odd01 = loadPieces(d, row + rowSkip, rowSkip);
    const auto even23 = loadPieces(d, row + 2, rowSkip), odd23 = loadPieces(d, row + 2 + rowSkip, rowSkip);
    return {{hn::InterleaveLower(d, even01, odd01), hn::InterleaveUpper(d, even01, odd01),
             hn::InterleaveLower(d, even23, odd23), hn::InterleaveUpper(d, even23, odd23)}};
}

template <class D, hwy::EnableIf<sizeof(hn::TFromD<D>) == 4> * = nullptr>
HWY_INLINE FourColumns<D> loadFourColumns(D d, const dReal *row, std::size_t rowSkip) {
    const auto row0 = loadPieces(d, row, rowSkip), row1 = loadPieces(d, row + rowSkip, rowSkip);
    const auto row2 = loadPieces(d, row + 2 * rowSkip, rowSkip),
               row3 = loadPieces(d, row + 3 * rowSkip, rowSkip);
    const auto even01 = hn::InterleaveLower(d, row0, row2), odd01 = hn::InterleaveLower(d, row1, row3);
    const auto even23 = hn::InterleaveUpper(d, row0, row2), odd23 = hn::InterleaveUpper(d, row1, row3);
    return {{hn::InterleaveLower(d, even01, odd01), hn::InterleaveUpper(d, even01, odd01),
             hn::InterleaveLower(d, even23, odd23), hn::InterleaveUpper(d, even23, odd23)}};
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#endif
