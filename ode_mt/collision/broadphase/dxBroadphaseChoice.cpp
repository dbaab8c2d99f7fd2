#include "collision/broadphase/dxBroadphaseChoice.h"

#include <algorithm>
#include <climits>

namespace {

using Threshold = dxBroadphaseThresholds;

bool isListWalk(const dxBroadphaseFacts &facts) {
    if (!facts.mayWalk) return false;
    const int minMoved = dxMinMovedToWalk(facts.order, facts.geoms);
    return minMoved != INT_MAX && (facts.moved >= minMoved || facts.current == dxBroadphaseKind::ListWalk);
}

// A list that is swept along one axis twice meets pairs that no search finds.
bool isAxisSweep(const dxBroadphaseFacts &facts) {
    if (!facts.comparesAllAxes) return true;
    const bool isNow = facts.current == dxBroadphaseKind::AxisSap;
    return facts.geoms <= (isNow ? Threshold::kMaxAxisSweep : Threshold::kMaxAxisSweepAgain);
}

bool isOrderedTable(const dxBroadphaseFacts &facts) {
    const bool isNow = facts.current == dxBroadphaseKind::OrderedTable;
    return facts.geoms <= (isNow ? Threshold::kMaxOrderedTable : Threshold::kMaxOrderedTable / 2);
}

bool isSlotTable(const dxBroadphaseFacts &facts) {
    const bool hasGrown = facts.current == dxBroadphaseKind::NeighbourList || facts.current == dxBroadphaseKind::NeighbourSets;
    return facts.slots <= (hasGrown ? Threshold::kMaxSlotTable / 2 : Threshold::kMaxSlotTable);
}

bool areNeighboursLost(const dxBroadphaseFacts &facts) {
    return facts.lookedUp >= Threshold::kMinLookUps && facts.lookedUp * Threshold::kListedPerLookUp >= facts.slots;
}

// All members have just come, or a table has become too small: a list takes all of them in at once.
dxBroadphaseKind chooseNeighbours(const dxBroadphaseFacts &facts) {
    const bool isTold = facts.callsAgainst >= Threshold::kCallsAgainst;
    if (facts.current == dxBroadphaseKind::NeighbourList)
        return isTold ? dxBroadphaseKind::NeighbourSets : dxBroadphaseKind::NeighbourList;
    if (facts.current == dxBroadphaseKind::NeighbourSets && !isTold && !areNeighboursLost(facts))
        return dxBroadphaseKind::NeighbourSets;
    return dxBroadphaseKind::NeighbourList;
}

}  // namespace

dxBroadphaseKind dxChooseBroadphase(const dxBroadphaseFacts &facts) {
    if (isListWalk(facts)) return dxBroadphaseKind::ListWalk;
    if (facts.order == dxPairOrder::Axis && isAxisSweep(facts)) return dxBroadphaseKind::AxisSap;
    const bool isByRank = facts.order == dxPairOrder::List || facts.order == dxPairOrder::Blocks;
    if (isByRank && isOrderedTable(facts)) return dxBroadphaseKind::OrderedTable;
    return isSlotTable(facts) ? dxBroadphaseKind::SlotTable : chooseNeighbours(facts);
}

bool dxSpeaksAgainst(const dxBroadphaseFacts &facts) {
    if (facts.current == dxBroadphaseKind::NeighbourList) return facts.changed * Threshold::kListedPerLookUp < facts.slots;
    return facts.current == dxBroadphaseKind::NeighbourSets && facts.changed * Threshold::kListedPerMove >= facts.slots;
}

int dxMinMovedToWalk(dxPairOrder order, int geoms) {
    if (order != dxPairOrder::List || geoms > Threshold::kMaxWalked) return INT_MAX;
    return geoms <= Threshold::kMaxAlwaysWalked ? 1 : 3 * geoms / 4;
}

std::size_t dxUnlimitedPairs(std::size_t) { return SIZE_MAX; }

std::size_t dxMaxPairsOfWalk(std::size_t geoms) {
    return std::clamp(geoms * geoms / 32, std::size_t{1} << 19, std::size_t{1} << 24);
}

std::size_t dxMaxPairsOfCells(std::size_t) { return std::size_t{1} << 22; }

dxPairLimit dxPairLimitOf(dxPairOrder order) {
    return order == dxPairOrder::Cells ? dxMaxPairsOfCells : dxMaxPairsOfWalk;
}
