#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxSolveL1Straight.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/kernels/dxRowTile-inl.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"
#include "dynamics/world_step/kernels/dxSolveL1Plain.h"

// Lanes are rows; several of upstream's groups of four make a block, so that enough independent sums are in
// flight.
HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

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
                           const dxSkyline &envelope) {
    HWY_ALIGN dReal sum[Rows];
    sumColumns<Rows, Stride>(L + firstRow * rowSkip, rowSkip, B, envelope.begin(firstRow, Rows, 4), firstRow, sum);
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
                              const dxSkyline &envelope) {
    std::size_t row = 0;
    const auto remain = [&](std::size_t rows) { return row + rows <= rowCount; };
    for (; row < kWideBlockColumns && remain(kNarrowBlock); row += kNarrowBlock)
        solveBlock<kNarrowBlock, Stride>(L, B, row, rowSkip, envelope);
    for (; remain(kWideBlock); row += kWideBlock) solveBlock<kWideBlock, Stride>(L, B, row, rowSkip, envelope);
    for (; remain(kNarrowBlock); row += kNarrowBlock)
        solveBlock<kNarrowBlock, Stride>(L, B, row, rowSkip, envelope);
    for (; remain(4); row += 4) solveBlock<4, Stride>(L, B, row, rowSkip, envelope);
    for (; row < rowCount; ++row) solveStraightSingle<Stride>(L + row * rowSkip, B, row);
}

void solveStraight1(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip,
                    const dxSkyline &envelope) {
    solveStraight<1>(L, B, rowCount, rowSkip, envelope);
}
void solveStraight2(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip) {
    solveStraight<2>(L, B, rowCount, rowSkip, dxSkyline());
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(solveStraight1);
HWY_EXPORT(solveStraight2);

// Up to this many rows vectors do not pay.
constexpr unsigned kPlainRows = 15;
}  // namespace dxSolve

void dxSolveL1Straight(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip, const dxSkyline &envelope) {
    using namespace dxSolve;
    if (rowCount <= kPlainRows) return solveStraightPlain<1>(L, B, rowCount, rowSkip);
    HWY_DYNAMIC_DISPATCH(solveStraight1)(L, B, rowCount, rowSkip, envelope);
}

template <>
void dxSolveL1Straight<1>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    dxSolveL1Straight(L, B, rowCount, rowSkip, dxSkyline());
}

template <>
void dxSolveL1Straight<2>(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    using namespace dxSolve;
    if (rowCount <= kPlainRows) return solveStraightPlain<2>(L, B, rowCount, rowSkip);
    HWY_DYNAMIC_DISPATCH(solveStraight2)(L, B, rowCount, rowSkip);
}
#endif
