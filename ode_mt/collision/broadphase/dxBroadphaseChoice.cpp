#include "collision/broadphase/dxBroadphaseChoice.h"

#include <algorithm>
#include <climits>

namespace {

using Threshold = dxBroadphaseThresholds;

// Nanoseconds on an AMD EPYC with AVX2; only their ratios matter.
struct Costs {
    double call;
    double geom;        // that is looked up or put into a row
    double comparison;  // of two boxes, with SIMD
    double found;       // of a pair that is found
    double kept;        // of a pair that is kept while others change
};
constexpr Costs kBruteForce{150, 30, 1.7, 8, 4};  // dxBruteForcePairs
constexpr Costs kSorted{300, 60, 0, 110, 30};     // dxAdaptiveBroadphase, dxKeptPairs
constexpr Costs kPlaced{300, 60, 0, 110, 60};     // the same, where kept pairs get new places (dxSapPairOrder)
constexpr Costs kRows{20, 20, 1.7, 3, 0};         // dxPairRows
constexpr Costs kHashRows{50, 60, 1.7, 10, 0};    // dxHashRows

bool isByRank(dxPairOrder order) { return order == dxPairOrder::List || order == dxPairOrder::Blocks; }

bool isListWalk(const dxBroadphaseFacts &facts) {
    if (!facts.mayWalk) return false;
    const int minMoved = dxMinMovedToWalk(facts.order, facts.geoms);
    const bool isNow = facts.current == dxBroadphaseKind::ListWalk;
    const std::size_t maxComparisons = (isNow ? 2 : 1) * Threshold::kMaxComparisonsWalked * static_cast<std::size_t>(facts.geoms);
    if (facts.order == dxPairOrder::Axis && facts.comparisons > maxComparisons) return false;
    return minMoved != INT_MAX && (facts.moved >= minMoved || isNow);
}

bool isOrderedBruteForce(const dxBroadphaseFacts &facts) {
    const bool isNow = facts.current == dxBroadphaseKind::OrderedBruteForce;
    return facts.geoms <= (isNow ? Threshold::kMaxOrderedBruteForce : Threshold::kMaxOrderedBruteForce / 2);
}

bool isBruteForce(const dxBroadphaseFacts &facts) {
    const bool hasGrown = facts.current == dxBroadphaseKind::VerletList || facts.current == dxBroadphaseKind::Neighbours;
    return facts.slots <= (hasGrown ? Threshold::kMaxBruteForce / 2 : Threshold::kMaxBruteForce);
}

bool isListCheaper(const dxBroadphaseFacts &facts) {
    return facts.lookedUp >= Threshold::kMinLookUps && facts.lookedUp * Threshold::kListedPerLookUp >= facts.slots;
}

// A new space, or one that has outgrown brute force, begins with a list, which takes in all members at once.
dxBroadphaseKind chooseNeighbours(const dxBroadphaseFacts &facts) {
    const bool isMismatch = facts.mismatchStreak >= Threshold::kMinMismatchStreak;
    if (facts.current == dxBroadphaseKind::VerletList)
        return isMismatch ? dxBroadphaseKind::Neighbours : dxBroadphaseKind::VerletList;
    if (facts.current == dxBroadphaseKind::Neighbours && !isMismatch && !isListCheaper(facts))
        return dxBroadphaseKind::Neighbours;
    return dxBroadphaseKind::VerletList;
}

// For spaces whose walk visits cells (dxHashWalker). That takes as long for a pair as finding and sorting it, so the limit is for memory: half a GB
// while pairs are found.
std::size_t maxPairsOfCells(std::size_t /*geoms*/) { return std::size_t{1} << 22; }

}  // namespace

dxBroadphaseKind dxChooseBroadphase(const dxBroadphaseFacts &facts) {
    if (isListWalk(facts)) return dxBroadphaseKind::ListWalk;
    if (isByRank(facts.order) && isOrderedBruteForce(facts)) return dxBroadphaseKind::OrderedBruteForce;
    return isBruteForce(facts) ? dxBroadphaseKind::BruteForce : chooseNeighbours(facts);
}

bool dxPrefersOtherBroadphase(const dxBroadphaseFacts &facts) {
    if (facts.current == dxBroadphaseKind::VerletList) return facts.changed * Threshold::kListedPerLookUp < facts.slots;
    return facts.current == dxBroadphaseKind::Neighbours && facts.changed * Threshold::kListedPerMove >= facts.slots;
}

int dxMinMovedToWalk(dxPairOrder order, int geoms) {
    if (order == dxPairOrder::Axis) return geoms <= Threshold::kMaxAlwaysSwept ? 1 : geoms / 16;
    if (order != dxPairOrder::List || geoms > Threshold::kMaxWalked) return INT_MAX;
    return geoms <= Threshold::kMaxAlwaysWalked ? 1 : 3 * geoms / 4;
}

double dxCostOfKeeping(dxPairOrder order, const dxPairWork &work) {
    if (work.changed == 0) return 0;
    const Costs &costs = isByRank(order) && work.geoms <= static_cast<std::size_t>(Threshold::kMaxOrderedBruteForce) ? kBruteForce
                         : order == dxPairOrder::Axis ? kPlaced
                                                       : kSorted;
    const double geoms = static_cast<double>(work.geoms), changed = static_cast<double>(work.changed);
    return costs.call + changed * costs.geom + costs.comparison * changed * geoms + costs.found * static_cast<double>(work.found) +
           costs.kept * static_cast<double>(work.pairs);
}

double dxCostOfFindingAnew(dxPairOrder order, const dxPairWork &work) {
    const Costs &costs = order == dxPairOrder::Cells ? kHashRows : kRows;
    return costs.call + costs.geom * static_cast<double>(work.geoms) + costs.comparison * static_cast<double>(work.comparisons) +
           costs.found * static_cast<double>(work.overlaps);
}

std::size_t dxUnlimitedPairs(std::size_t) { return SIZE_MAX; }

std::size_t dxMaxPairsOfWalk(std::size_t geoms) {
    return std::clamp(geoms * geoms / 32, std::size_t{1} << 19, std::size_t{1} << 24);
}

dxPairLimit dxPairLimitOf(dxPairOrder order) {
    return order == dxPairOrder::Cells ? maxPairsOfCells : dxMaxPairsOfWalk;
}
