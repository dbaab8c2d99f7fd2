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
#include "dynamics/sweep/dxSweepRun.h"

HWY_BEFORE_NAMESPACE();
namespace dxSweeping {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

template <class Row>
HWY_INLINE void takeRow(const dxSweepIsland &island, const Row &row) {
    takeRowPlain(island, row);
}

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

constexpr hn::FixedTag<dReal, 1> kSingle;

// relax() of a packed row. In a large island's random order nobody can foresee whether a row is bounded by another one, and
// at which limit it is; and few rows wait for this one, so that a longer way to the change costs less than a wrong guess.
HWY_INLINE dReal relaxRow(const PackedRow &row, dReal delta) {
    const hn::RebindToSigned<decltype(kSingle)> whole;
    const auto isBounded = hn::RebindMask(
        kSingle, hn::Gt(hn::Set(whole, row.boundingRow()), hn::Set(whole, dxSweepIsland::kNone)));
    const auto ownLow = hn::LoadU(kSingle, row.jacobian() + dxSweepIsland::kLow);
    const auto ownHigh = hn::LoadU(kSingle, row.jacobian() + dxSweepIsland::kHigh);
    const auto one = hn::Set(kSingle, dReal(1));  // no endless limit meets a lambda of 0
    const auto factor = hn::IfThenElse(isBounded, hn::LoadU(kSingle, &row.boundingLambda()), one);
    const auto bound = hn::Abs(hn::Mul(ownHigh, factor));
    const auto high = hn::IfThenElse(isBounded, bound, ownHigh), low = hn::IfThenElse(isBounded, hn::Neg(bound), ownLow);

    const auto old = hn::LoadU(kSingle, &row.lambda()), change = hn::Set(kSingle, delta), wanted = hn::Add(old, change);
    const auto isLow = hn::Lt(wanted, low), isHigh = hn::Gt(wanted, high), isLimited = hn::Or(isLow, isHigh);
    const auto next = hn::IfThenElse(isLow, low, hn::IfThenElse(isHigh, high, wanted));
    hn::StoreU(next, kSingle, &row.lambda());
    // Less 0, where upstream subtracts nothing: an endless lambda less itself would raise an exception.
    const auto limited = hn::Sub(next, hn::IfThenElseZero(isLimited, old));
    return hn::GetLane(hn::IfThenElse(isLimited, limited, change));
}

HWY_INLINE dReal relaxRow(const ArrayRow &row, dReal delta) { return relax(row, delta); }

// Both bodies at once.
template <class Row>
HWY_INLINE void takeRowOfTwo(const dxSweepIsland &island, const Row &row) {
    dReal *const out1 = forceOn(island, row, 0), *const out2 = forceOn(island, row, 1);
    const Six force1 = load(out1), force2 = load(out2);
    const Pair sum = sums(products(force1, load(row.jacobian() + dxSweepIsland::kBody1)),
                          products(force2, load(row.jacobian() + dxSweepIsland::kBody2)));
    const dReal delta = residual(row) - hn::GetLane(sum) - upper(sum);
    const Pair change = hn::Set(kPair, relaxRow(row, delta));
    addImpulse(force1, change, row.impulse() + dxSweepIsland::kOn1, out1);
    addImpulse(force2, change, row.impulse() + dxSweepIsland::kOn2, out2);
}

template <class Row>
HWY_INLINE void takeRow(const dxSweepIsland &island, const Row &row) {
    if (hasSecondBody(row)) {
        takeRowOfTwo(island, row);
    } else {
        takeRowPlain(island, row);
    }
}

#endif

// In large islands the rows are not in the nearest cache, and the processor cannot foresee a random order.
HWY_INLINE void prefetch(const PackedRow &row) {
    hwy::Prefetch(row.jacobian());
    hwy::Prefetch(row.jacobian() + dxSweepIsland::kBody2);
    hwy::Prefetch(row.impulse());
    hwy::Prefetch(&row.lambda());
}

constexpr std::size_t kAhead = 8;  // rows: enough to hide a load from the third cache

void sweepArrays(const dxSweepIsland &shared, const int *order) {
    const dxSweepIsland island = shared;  // a copy of its own, which no store can change
    for (unsigned i = 0; i < island.rows; ++i) takeRow(island, ArrayRow(island, static_cast<std::size_t>(order[i])));
}

void sweepPacked(const dxSweepIsland &shared, const int *order) {
    const dxSweepIsland island = shared;
    for (std::size_t i = 0; i < island.rows; ++i) {
        prefetch(PackedRow(island, static_cast<std::size_t>(order[std::min<std::size_t>(i + kAhead, island.rows - 1)])));
        takeRow(island, PackedRow(island, static_cast<std::size_t>(order[i])));
    }
}

std::size_t takeRun(const dxSweepIsland &shared, const std::uint32_t *entries, std::size_t begin, std::size_t end) {
    using namespace dxSweepRun;
    const dxSweepIsland island = shared;
    for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t entry = entries[i];
        if ((entry & kWaits) != 0 && i != begin) return i;
        prefetch(PackedRow(island, entries[std::min(i + kAhead, end - 1)] & kRow));
        takeRow(island, PackedRow(island, entry & kRow));
        if ((entry & kAnnounces) != 0) return i + 1;
    }
    return end;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSweeping
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSweeping {
HWY_EXPORT(sweepArrays);
HWY_EXPORT(sweepPacked);
HWY_EXPORT(takeRun);
}  // namespace dxSweeping

void dxSweep(const dxSweepIsland &island, const int *order) {
    using namespace dxSweeping;
    if (island.packed == nullptr) {
        HWY_DYNAMIC_DISPATCH(sweepArrays)(island, order);
    } else {
        HWY_DYNAMIC_DISPATCH(sweepPacked)(island, order);
    }
}

std::size_t dxTakeRun(const dxSweepIsland &island, const std::uint32_t *entries, std::size_t begin, std::size_t end) {
    using namespace dxSweeping;
    return HWY_DYNAMIC_DISPATCH(takeRun)(island, entries, begin, end);
}
#endif
