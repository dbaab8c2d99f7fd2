#include "simd/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/sweep/dxSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "dynamics/sweep/dxSweep.h"
#include "dynamics/sweep/dxSweepPlain.h"

HWY_BEFORE_NAMESPACE();
namespace dxSweeping {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void takeRow(const dxSweepIsland &island, std::size_t index) { takeRowPlain(island, index); }

#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::FixedTag<dReal, 2> kPair;
using Pair = hn::Vec<decltype(kPair)>;

// The numbers of a body.
struct Six {
    Pair v01, v23, v45;
};

HWY_INLINE Six load(const dReal *p) {
    return {hn::LoadU(kPair, p), hn::LoadU(kPair, p + 2), hn::LoadU(kPair, p + 4)};
}

HWY_INLINE Six products(const Six &a, const Six &b) {
    return {hn::Mul(a.v01, b.v01), hn::Mul(a.v23, b.v23), hn::Mul(a.v45, b.v45)};
}

// The sum of each, in the order of upstream: lane 0 a's, lane 1 b's.
HWY_INLINE Pair sums(const Six &a, const Six &b) {
    Pair sum = hn::Add(hn::InterleaveLower(kPair, a.v01, b.v01), hn::InterleaveUpper(kPair, a.v01, b.v01));
    sum = hn::Add(sum, hn::InterleaveLower(kPair, a.v23, b.v23));
    sum = hn::Add(sum, hn::InterleaveUpper(kPair, a.v23, b.v23));
    sum = hn::Add(sum, hn::InterleaveLower(kPair, a.v45, b.v45));
    return hn::Add(sum, hn::InterleaveUpper(kPair, a.v45, b.v45));
}

HWY_INLINE dReal upper(Pair pair) { return hn::GetLane(hn::DupOdd(pair)); }

HWY_INLINE void addImpulse(const Six &force, Pair delta, const dReal *impulse, dReal *out) {
    const Six change = load(impulse);
    hn::StoreU(hn::Add(force.v01, hn::Mul(delta, change.v01)), kPair, out);
    hn::StoreU(hn::Add(force.v23, hn::Mul(delta, change.v23)), kPair, out + 2);
    hn::StoreU(hn::Add(force.v45, hn::Mul(delta, change.v45)), kPair, out + 4);
}

// Both bodies at once.
HWY_INLINE void takeRowOfTwo(const dxSweepIsland &island, std::size_t index) {
    const dReal *row = island.jacobian + index * dxSweepIsland::kJacobianColumns;
    const dReal *impulse = island.impulse + index * dxSweepIsland::kImpulseColumns;
    dReal *out1 = forceOn(island, index, 0), *out2 = forceOn(island, index, 1);
    const Six force1 = load(out1), force2 = load(out2);
    const Pair sum = sums(products(force1, load(row + dxSweepIsland::kBody1)),
                          products(force2, load(row + dxSweepIsland::kBody2)));
    const dReal delta = residual(island, index) - hn::GetLane(sum) - upper(sum);
    const Pair change = hn::Set(kPair, relax(island, index, delta));
    addImpulse(force1, change, impulse + dxSweepIsland::kOn1, out1);
    addImpulse(force2, change, impulse + dxSweepIsland::kOn2, out2);
}

HWY_INLINE void takeRow(const dxSweepIsland &island, std::size_t index) {
    if (hasSecondBody(island, index)) {
        takeRowOfTwo(island, index);
    } else {
        takeRowPlain(island, index);
    }
}

#endif

// In large islands the rows are not in the nearest cache, and the processor cannot foresee a random order.
HWY_INLINE void prefetchRow(const dxSweepIsland &island, std::size_t index) {
    const dReal *row = island.jacobian + index * dxSweepIsland::kJacobianColumns;
    const dReal *impulse = island.impulse + index * dxSweepIsland::kImpulseColumns;
    hwy::Prefetch(row);
    hwy::Prefetch(row + dxSweepIsland::kBody2);
    hwy::Prefetch(impulse);
    hwy::Prefetch(impulse + dxSweepIsland::kImpulseColumns - 1);
    hwy::Prefetch(island.lambda + index);
    hwy::Prefetch(island.bodiesOfRow + 2 * index);
    hwy::Prefetch(island.boundingRow + index);
}

void sweepSmall(const dxSweepIsland &shared, const int *order) {
    const dxSweepIsland island = shared;  // a copy of its own, which no store can change
    for (unsigned i = 0; i < island.rows; ++i) takeRow(island, static_cast<std::size_t>(order[i]));
}

void sweepLarge(const dxSweepIsland &shared, const int *order) {
    constexpr unsigned kAhead = 8;  // rows: enough to hide a load from the third cache
    const dxSweepIsland island = shared;
    for (unsigned i = 0; i < island.rows; ++i) {
        prefetchRow(island, static_cast<std::size_t>(order[std::min(i + kAhead, island.rows - 1)]));
        takeRow(island, static_cast<std::size_t>(order[i]));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSweeping
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSweeping {
HWY_EXPORT(sweepSmall);
HWY_EXPORT(sweepLarge);

// Rows; about the second cache.
constexpr unsigned kLarge = 1000;
}  // namespace dxSweeping

void dxSweep(const dxSweepIsland &island, const int *order) {
    using namespace dxSweeping;
    if (island.rows < kLarge) {
        HWY_DYNAMIC_DISPATCH(sweepSmall)(island, order);
    } else {
        HWY_DYNAMIC_DISPATCH(sweepLarge)(island, order);
    }
}
#endif
