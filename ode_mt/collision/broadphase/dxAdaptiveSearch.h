// The search that a space uses unless it is told otherwise: whichever dxChooseBroadPhase() takes of the table of slots,
// the neighbour list and the neighbour sets.
#pragma once

#include <memory>

#include "collision/broadphase/dxBroadPhaseChoice.h"
#include "collision/broadphase/dxNeighbourSearch.h"
#include "collision/broadphase/dxPairSearch.h"
#include "collision/broadphase/dxTableSearch.h"
#include "collision/broadphase/dxVerletSearch.h"

class dxAdaptiveSearch final : public dxPairSearch {
public:
    // `mostPairs` is as in dxBatchSearch.
    explicit dxAdaptiveSearch(dxPairLimit maxPairs = dxUnlimitedPairs) : m_maxPairs(maxPairs) {}

    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    dxBroadPhase current() const;

private:
    dxBroadPhaseFacts factsOf(const dxMembers &members) const;
    void chooseBySize(const dxMembers &members);
    void searchVerlet(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);
    void searchNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);

    const dxPairLimit m_maxPairs;
    // One of them exists from the first call on.
    std::unique_ptr<dxTableSearch> m_table;
    std::unique_ptr<dxVerletSearch> m_verlet;
    std::unique_ptr<dxNeighbourSearch> m_neighbours;
    int m_callsAgainst = 0;  // in a row (dxSpeaksAgainst)
};
