// The search that a space uses unless it is told otherwise: in a small space a table of all boxes, in others neighbours
// while few boxes move, and a list of candidates while many do.
//
// Which of them it is shows in the time that it takes, not in what is found.
#pragma once

#include <memory>

#include "collision/dxCrowd.h"
#include "collision/dxNeighbourSearch.h"
#include "collision/dxPairSearch.h"
#include "collision/dxTableSearch.h"
#include "collision/dxVerletSearch.h"

class dxAdaptiveSearch final : public dxPairSearch {
public:
    // As for dxBatchSearch.
    explicit dxAdaptiveSearch(dxCrowd::Limit mostPairs = dxCrowd::allPairs) : m_mostPairs(mostPairs) {}

    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    bool isTable() const { return m_table != nullptr; }
    bool isVerlet() const { return m_verlet != nullptr; }

private:
    void chooseTable(const dxMembers &members);
    void searchVerlet(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);
    void searchNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);

    const dxCrowd::Limit m_mostPairs;
    // One of them is there from the first call on.
    std::unique_ptr<dxTableSearch> m_table;
    std::unique_ptr<dxVerletSearch> m_verlet;
    std::unique_ptr<dxNeighbourSearch> m_neighbours;
    int m_callsAgainst = 0;  // in a row, that speak for the other way than the one in use
};
