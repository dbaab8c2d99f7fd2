// Velocities of bodies as lanes: kLanes bodies, each a line of eight numbers of which six are used, become six vectors, and back.
//
// Included once for each instruction set, inside HWY_NAMESPACE.
#if defined(DX_BODY_TRANSPOSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DX_BODY_TRANSPOSE_INL_H
#undef DX_BODY_TRANSPOSE_INL_H
#else
#define DX_BODY_TRANSPOSE_INL_H
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "dynamics/quick_step/fast/dxContactPack.h"

HWY_BEFORE_NAMESPACE();
namespace dxIterative {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using LaneTag = hn::CappedTag<dReal, dxLanes::kCount>;
using Lane = hn::Vec<LaneTag>;
constexpr unsigned kLanes = hn::MaxLanes(LaneTag());

// The components of kLanes vectors with six components.
struct Motion {
    Lane v[3], w[3];
};

#if HWY_TARGET != HWY_SCALAR

// Blocks of two numbers: of [a0 a1 a2 a3], [b0 ...] the even blocks [a0 b0 a2 b2] and the odd ones [a1 b1 a3 b3].
HWY_INLINE Lane evenBlocks(Lane a, Lane b) { return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a); }
HWY_INLINE Lane oddBlocks(Lane a, Lane b) { return hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)); }

// Rows of eight numbers.
HWY_INLINE Motion loadEight(const dReal *const *rows) {
    const LaneTag d;
    Lane low[4], high[4];  // components 0, 2, 4, 6 and 1, 3, 5, 7 of two rows
    for (unsigned i = 0; i < 4; ++i) {
        const Lane a = hn::LoadU(d, rows[2 * i]), b = hn::LoadU(d, rows[2 * i + 1]);
        low[i] = hn::InterleaveLower(d, a, b);
        high[i] = hn::InterleaveUpper(d, a, b);
    }
    const Lane evenLow0 = evenBlocks(low[0], low[1]), evenLow1 = evenBlocks(low[2], low[3]);
    const Lane oddLow0 = oddBlocks(low[0], low[1]), oddLow1 = oddBlocks(low[2], low[3]);
    const Lane evenHigh0 = evenBlocks(high[0], high[1]), evenHigh1 = evenBlocks(high[2], high[3]);
    const Lane oddHigh0 = oddBlocks(high[0], high[1]), oddHigh1 = oddBlocks(high[2], high[3]);
    return {{hn::ConcatLowerLower(d, evenLow1, evenLow0), hn::ConcatLowerLower(d, evenHigh1, evenHigh0),
             hn::ConcatLowerLower(d, oddLow1, oddLow0)},
            {hn::ConcatLowerLower(d, oddHigh1, oddHigh0), hn::ConcatUpperUpper(d, evenLow1, evenLow0),
             hn::ConcatUpperUpper(d, evenHigh1, evenHigh0)}};
}

HWY_INLINE void storeEight(const Motion &motion, dReal *const *rows) {
    const LaneTag d;
    const Lane none = hn::Zero(d);
    const Lane evenLow0 = hn::ConcatLowerLower(d, motion.w[1], motion.v[0]),
               evenLow1 = hn::ConcatUpperUpper(d, motion.w[1], motion.v[0]);
    const Lane evenHigh0 = hn::ConcatLowerLower(d, motion.w[2], motion.v[1]),
               evenHigh1 = hn::ConcatUpperUpper(d, motion.w[2], motion.v[1]);
    const Lane oddLow0 = hn::ConcatLowerLower(d, none, motion.v[2]), oddLow1 = hn::ConcatUpperUpper(d, none, motion.v[2]);
    const Lane oddHigh0 = hn::ConcatLowerLower(d, none, motion.w[0]), oddHigh1 = hn::ConcatUpperUpper(d, none, motion.w[0]);
    const Lane low[4] = {evenBlocks(evenLow0, oddLow0), oddBlocks(evenLow0, oddLow0), evenBlocks(evenLow1, oddLow1),
                         oddBlocks(evenLow1, oddLow1)};
    const Lane high[4] = {evenBlocks(evenHigh0, oddHigh0), oddBlocks(evenHigh0, oddHigh0), evenBlocks(evenHigh1, oddHigh1),
                          oddBlocks(evenHigh1, oddHigh1)};
    for (unsigned i = 0; i < 4; ++i) {
        hn::StoreU(hn::InterleaveLower(d, low[i], high[i]), d, rows[2 * i]);
        hn::StoreU(hn::InterleaveUpper(d, low[i], high[i]), d, rows[2 * i + 1]);
    }
}

// Components [first, first + 4) of four rows.
HWY_INLINE void loadFour(const dReal *const *rows, unsigned first, Lane *columns) {
    const LaneTag d;
    const Lane a = hn::LoadU(d, rows[0] + first), b = hn::LoadU(d, rows[1] + first);
    const Lane c = hn::LoadU(d, rows[2] + first), e = hn::LoadU(d, rows[3] + first);
    const Lane low0 = hn::InterleaveLower(d, a, b), high0 = hn::InterleaveUpper(d, a, b);
    const Lane low1 = hn::InterleaveLower(d, c, e), high1 = hn::InterleaveUpper(d, c, e);
    columns[0] = hn::ConcatLowerLower(d, low1, low0);
    columns[1] = hn::ConcatLowerLower(d, high1, high0);
    columns[2] = hn::ConcatUpperUpper(d, low1, low0);
    columns[3] = hn::ConcatUpperUpper(d, high1, high0);
}

HWY_INLINE void storeFour(const Lane *columns, unsigned first, dReal *const *rows) {
    const LaneTag d;
    const Lane low0 = hn::ConcatLowerLower(d, columns[2], columns[0]), low1 = hn::ConcatUpperUpper(d, columns[2], columns[0]);
    const Lane high0 = hn::ConcatLowerLower(d, columns[3], columns[1]), high1 = hn::ConcatUpperUpper(d, columns[3], columns[1]);
    hn::StoreU(hn::InterleaveLower(d, low0, high0), d, rows[0] + first);
    hn::StoreU(hn::InterleaveUpper(d, low0, high0), d, rows[1] + first);
    hn::StoreU(hn::InterleaveLower(d, low1, high1), d, rows[2] + first);
    hn::StoreU(hn::InterleaveUpper(d, low1, high1), d, rows[3] + first);
}

#endif

// Any number of lanes, by way of memory.
HWY_INLINE Motion loadByElements(const dReal *const *rows) {
    const LaneTag d;
    HWY_ALIGN dReal columns[6][dxLanes::kCount];
    for (unsigned row = 0; row < kLanes; ++row)
        for (unsigned i = 0; i < 6; ++i) columns[i][row] = rows[row][i];
    return {{hn::Load(d, columns[0]), hn::Load(d, columns[1]), hn::Load(d, columns[2])},
            {hn::Load(d, columns[3]), hn::Load(d, columns[4]), hn::Load(d, columns[5])}};
}

HWY_INLINE void storeByElements(const Motion &motion, dReal *const *rows) {
    const LaneTag d;
    HWY_ALIGN dReal columns[6][dxLanes::kCount];
    for (unsigned i = 0; i < 3; ++i) {
        hn::Store(motion.v[i], d, columns[i]);
        hn::Store(motion.w[i], d, columns[3 + i]);
    }
    for (unsigned row = 0; row < kLanes; ++row)
        for (unsigned i = 0; i < 6; ++i) rows[row][i] = columns[i][row];
}

// Of kLanes bodies.
HWY_INLINE Motion loadMotion(const dReal *const *rows) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kLanes == 8 && sizeof(dReal) == 8) {
        return loadEight(rows);
    } else if constexpr (kLanes == 4 && sizeof(dReal) == 8) {
        Lane columns[8];
        loadFour(rows, 0, columns);
        loadFour(rows, 4, columns + 4);
        return {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}};
    }
#endif
    return loadByElements(rows);
}

HWY_INLINE void storeMotion(const Motion &motion, dReal *const *rows) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kLanes == 8 && sizeof(dReal) == 8) {
        return storeEight(motion, rows);
    } else if constexpr (kLanes == 4 && sizeof(dReal) == 8) {
        const Lane none = hn::Zero(LaneTag());
        const Lane columns[8] = {motion.v[0], motion.v[1], motion.v[2], motion.w[0], motion.w[1], motion.w[2], none, none};
        storeFour(columns, 0, rows);
        return storeFour(columns + 4, 4, rows);
    }
#endif
    storeByElements(motion, rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxIterative
HWY_AFTER_NAMESPACE();

#endif
