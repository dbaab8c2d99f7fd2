#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/quick_step/sor/dxSorSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "dynamics/quick_step/sor/dxSorPlain.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"

HWY_BEFORE_NAMESPACE();
namespace dxSorKernels {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

struct Branching;
struct BranchFree;

template <class Relaxation>
HWY_INLINE void takeRow(const dxIslandProblem &problem, Row &row) {
    takeRowPlain(problem, row);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::FixedTag<dReal, 2> kPair;
using Pair = hn::Vec<decltype(kPair)>;

// The numbers of a body in pairs.
struct SixInPairs {
    Pair v01, v23, v45;

    static HWY_INLINE SixInPairs load(const dReal *p) {
        return {hn::LoadU(kPair, p), hn::LoadU(kPair, p + 2), hn::LoadU(kPair, p + 4)};
    }

    HWY_INLINE SixInPairs times(const SixInPairs &b) const {
        return {hn::Mul(v01, b.v01), hn::Mul(v23, b.v23), hn::Mul(v45, b.v45)};
    }

    // The sum of each, in the order of upstream: lane 0 a's, lane 1 b's.
    static HWY_INLINE Pair sums(const SixInPairs &a, const SixInPairs &b) {
        Pair sum = hn::Add(hn::InterleaveLower(kPair, a.v01, b.v01), hn::InterleaveUpper(kPair, a.v01, b.v01));
        sum = hn::Add(sum, hn::InterleaveLower(kPair, a.v23, b.v23));
        sum = hn::Add(sum, hn::InterleaveUpper(kPair, a.v23, b.v23));
        sum = hn::Add(sum, hn::InterleaveLower(kPair, a.v45, b.v45));
        return hn::Add(sum, hn::InterleaveUpper(kPair, a.v45, b.v45));
    }

    HWY_INLINE void addAndStore(dReal factor, const dReal *impulse, dReal *out) const {
        const SixInPairs change = load(impulse);
        const Pair lanes = hn::Set(kPair, factor);
        hn::StoreU(hn::Add(v01, hn::Mul(lanes, change.v01)), kPair, out);
        hn::StoreU(hn::Add(v23, hn::Mul(lanes, change.v23)), kPair, out + 2);
        hn::StoreU(hn::Add(v45, hn::Mul(lanes, change.v45)), kPair, out + 4);
    }
};

// The same, the first four in one vector of `Four`, whose halves are blocks of two lanes.
template <class Four>
struct SixInFour {
    hn::Vec<Four> v0123;
    Pair v45;

    static HWY_INLINE SixInFour load(const dReal *p) { return {hn::LoadU(Four(), p), hn::LoadU(kPair, p + 4)}; }

    HWY_INLINE SixInFour times(const SixInFour &b) const { return {hn::Mul(v0123, b.v0123), hn::Mul(v45, b.v45)}; }

    static HWY_INLINE Pair sums(const SixInFour &a, const SixInFour &b) {
        const auto v02 = hn::InterleaveLower(Four(), a.v0123, b.v0123), v13 = hn::InterleaveUpper(Four(), a.v0123, b.v0123);
        Pair sum = hn::Add(hn::LowerHalf(kPair, v02), hn::LowerHalf(kPair, v13));
        sum = hn::Add(sum, hn::UpperHalf(kPair, v02));
        sum = hn::Add(sum, hn::UpperHalf(kPair, v13));
        sum = hn::Add(sum, hn::InterleaveLower(kPair, a.v45, b.v45));
        return hn::Add(sum, hn::InterleaveUpper(kPair, a.v45, b.v45));
    }

    HWY_INLINE void addAndStore(dReal factor, const dReal *impulse, dReal *out) const {
        const SixInFour change = load(impulse);
        hn::StoreU(hn::Add(v0123, hn::Mul(hn::Set(Four(), factor), change.v0123)), Four(), out);
        hn::StoreU(hn::Add(v45, hn::Mul(hn::Set(kPair, factor), change.v45)), kPair, out + 4);
    }
};

using AtMostFour = hn::CappedTag<dReal, 4>;
constexpr bool kHasFour = hn::MaxLanes(AtMostFour()) == 4 && sizeof(dReal) == 8;
using Six = std::conditional_t<kHasFour, SixInFour<AtMostFour>, SixInPairs>;

HWY_INLINE dReal upper(Pair pair) { return hn::GetLane(hn::DupOdd(pair)); }

// relax() with branches, for rows in the order of their joints, whose branches are predictable.
struct Branching {
    static HWY_INLINE dReal relaxRow(const dxIslandProblem &problem, Row &row, dReal delta) { return relax(problem, row, delta); }
};

constexpr hn::FixedTag<dReal, 1> kSingle;

// relax() without branches. In a large island's random order it is unpredictable whether another row bounds a row, and at which
// limit the row is; and few rows wait for this one, so that a longer dependency chain costs less than a misprediction.
struct BranchFree {
    static HWY_INLINE dReal relaxRow(const dxIslandProblem &problem, Row &row, dReal delta) {
        const hn::RebindToSigned<decltype(kSingle)> whole;
        const auto hasFrictionIndex =
            hn::RebindMask(kSingle, hn::Gt(hn::Set(whole, row.boundingRow), hn::Set(whole, Row::kNone)));
        const auto ownLow = hn::LoadU(kSingle, row.jacobian + Row::kLow);
        const auto ownHigh = hn::LoadU(kSingle, row.jacobian + Row::kHigh);
        const auto one = hn::Set(kSingle, dReal(1));  // an infinite limit times a lambda of 0 would be no number
        const auto factor = hn::IfThenElse(hasFrictionIndex, hn::LoadU(kSingle, &boundingRowOf(problem, row).lambda), one);
        const auto bound = hn::Abs(hn::Mul(ownHigh, factor));
        const auto high = hn::IfThenElse(hasFrictionIndex, bound, ownHigh);
        const auto low = hn::IfThenElse(hasFrictionIndex, hn::Neg(bound), ownLow);

        const auto old = hn::LoadU(kSingle, &row.lambda), change = hn::Set(kSingle, delta), wanted = hn::Add(old, change);
        const auto isLow = hn::Lt(wanted, low), isHigh = hn::Gt(wanted, high), isLimited = hn::Or(isLow, isHigh);
        const auto next = hn::IfThenElse(isLow, low, hn::IfThenElse(isHigh, high, wanted));
        hn::StoreU(next, kSingle, &row.lambda);
        // Less 0, where upstream subtracts nothing: an infinite lambda less itself would raise an exception.
        const auto limited = hn::Sub(next, hn::IfThenElseZero(isLimited, old));
        return hn::GetLane(hn::IfThenElse(isLimited, limited, change));
    }

private:
    // The row itself, if no row bounds it; found without a branch.
    static HWY_INLINE const Row &boundingRowOf(const dxIslandProblem &problem, const Row &row) {
        const std::ptrdiff_t own = &row - problem.rows, other = row.boundingRow, noneMask = -std::ptrdiff_t(other < 0);
        return problem.rows[(own & noneMask) | (other & ~noneMask)];
    }
};

template <class Relaxation>
HWY_INLINE void takeRow(const dxIslandProblem &problem, Row &row) {
    dReal *const out1 = problem.accelerationOf(row.body[0]);
    const Six on1 = Six::load(out1);
    if (!row.hasSecondBody()) {
        on1.addAndStore(relax(problem, row, residual(row) - dot6(out1, row.jacobian + Row::kBody1)), row.impulseOn1, out1);
        return;
    }
    // Both bodies at once.
    dReal *const out2 = problem.accelerationOf(row.body[1]);
    const Six on2 = Six::load(out2);
    const Pair sum = Six::sums(on1.times(Six::load(row.jacobian + Row::kBody1)), on2.times(Six::load(row.jacobian + Row::kBody2)));
    const dReal change = Relaxation::relaxRow(problem, row, residual(row) - hn::GetLane(sum) - upper(sum));
    on1.addAndStore(change, row.impulseOn1, out1);
    on2.addAndStore(change, row.impulseOn2, out2);
}

#endif

// In a large island the rows are in no near cache, and the hardware cannot predict a random order.
HWY_INLINE void prefetch(const Row &row) {
    hwy::Prefetch(row.jacobian);
    hwy::Prefetch(row.jacobian + Row::kBody2);
    hwy::Prefetch(row.impulseOn1);
    hwy::Prefetch(row.impulseOn2);
}

constexpr std::size_t kPrefetchDistance = 8;  // rows: enough to hide a load from L3

void sweepSmall(const dxIslandProblem &shared, const int *order) {
    const dxIslandProblem problem = shared;  // a copy of its own, which no store can change
    for (unsigned i = 0; i < problem.rowCount; ++i) takeRow<Branching>(problem, problem.rows[order[i]]);
}

void sweepLarge(const dxIslandProblem &shared, const int *order) {
    const dxIslandProblem problem = shared;
    for (std::size_t i = 0; i < problem.rowCount; ++i) {
        prefetch(problem.rows[order[std::min<std::size_t>(i + kPrefetchDistance, problem.rowCount - 1)]]);
        takeRow<BranchFree>(problem, problem.rows[order[i]]);
    }
}

std::size_t takeRun(const dxIslandProblem &shared, const std::uint32_t *entries, std::size_t begin, std::size_t end) {
    using namespace dxSorRun;
    const dxIslandProblem problem = shared;
    for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t entry = entries[i];
        if ((entry & kWaits) != 0 && i != begin) return i;
        prefetch(problem.rows[entries[std::min(i + kPrefetchDistance, end - 1)] & kRow]);
        takeRow<BranchFree>(problem, problem.rows[entry & kRow]);
        if ((entry & kAnnounces) != 0) return i + 1;
    }
    return end;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSorKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSorKernels {
HWY_EXPORT(sweepSmall);
HWY_EXPORT(sweepLarge);
HWY_EXPORT(takeRun);
}  // namespace dxSorKernels

void dxSorSweep(const dxIslandProblem &problem, const int *order, bool isLarge) {
    using namespace dxSorKernels;
    if (isLarge) {
        HWY_DYNAMIC_DISPATCH(sweepLarge)(problem, order);
    } else {
        HWY_DYNAMIC_DISPATCH(sweepSmall)(problem, order);
    }
}

std::size_t dxRelaxRun(const dxIslandProblem &problem, const std::uint32_t *entries, std::size_t begin, std::size_t end) {
    using namespace dxSorKernels;
    return HWY_DYNAMIC_DISPATCH(takeRun)(problem, entries, begin, end);
}
#endif
