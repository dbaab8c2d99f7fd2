#include "collision/broadphase/dxBroadPhaseChoice.h"

#include <algorithm>
#include <climits>

namespace {

using Threshold = dxBroadPhaseThresholds;

bool isListWalk(const dxBroadPhaseFacts &facts) {
    if (!facts.mayWalk) return false;
    const int minMoved = dxMinMovedToWalk(facts.order, facts.geoms);
    return minMoved != INT_MAX && (facts.moved >= minMoved || facts.current == dxBroadPhase::ListWalk);
}

// A list that is swept along one axis twice meets pairs that no search finds.
bool isAxisSweep(const dxBroadPhaseFacts &facts) {
    if (!facts.comparesAllAxes) return true;
    const bool isNow = facts.current == dxBroadPhase::AxisSap;
    return facts.geoms <= (isNow ? Threshold::kMaxAxisSweep : Threshold::kMaxAxisSweepAgain);
}

bool isOrderedTable(const dxBroadPhaseFacts &facts) {
    const bool isNow = facts.current == dxBroadPhase::OrderedTable;
    return facts.geoms <= (isNow ? Threshold::kMaxOrderedTable : Threshold::kMaxOrderedTable / 2);
}

bool isSlotTable(const dxBroadPhaseFacts &facts) {
    const bool hasGrown = facts.current == dxBroadPhase::NeighbourList || facts.current == dxBroadPhase::NeighbourSets;
    return facts.slots <= (hasGrown ? Threshold::kMaxSlotTable / 2 : Threshold::kMaxSlotTable);
}

bool areNeighboursLost(const dxBroadPhaseFacts &facts) {
    return facts.lookedUp >= Threshold::kMinLookUps && facts.lookedUp * Threshold::kListedPerLookUp >= facts.slots;
}

// All members have just come, or a table has become too small: a list takes all of them in at once.
dxBroadPhase chooseNeighbours(const dxBroadPhaseFacts &facts) {
    const bool isTold = facts.callsAgainst >= Threshold::kCallsAgainst;
    if (facts.current == dxBroadPhase::NeighbourList)
        return isTold ? dxBroadPhase::NeighbourSets : dxBroadPhase::NeighbourList;
    if (facts.current == dxBroadPhase::NeighbourSets && !isTold && !areNeighboursLost(facts))
        return dxBroadPhase::NeighbourSets;
    return dxBroadPhase::NeighbourList;
}

}  // namespace

dxBroadPhase dxChooseBroadPhase(const dxBroadPhaseFacts &facts) {
    if (isListWalk(facts)) return dxBroadPhase::ListWalk;
    if (facts.order == dxPairOrder::Axis && isAxisSweep(facts)) return dxBroadPhase::AxisSap;
    const bool isByRank = facts.order == dxPairOrder::List || facts.order == dxPairOrder::Blocks;
    if (isByRank && isOrderedTable(facts)) return dxBroadPhase::OrderedTable;
    return isSlotTable(facts) ? dxBroadPhase::SlotTable : chooseNeighbours(facts);
}

bool dxSpeaksAgainst(const dxBroadPhaseFacts &facts) {
    if (facts.current == dxBroadPhase::NeighbourList) return facts.changed * Threshold::kListedPerLookUp < facts.slots;
    return facts.current == dxBroadPhase::NeighbourSets && facts.changed * Threshold::kListedPerMove >= facts.slots;
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
