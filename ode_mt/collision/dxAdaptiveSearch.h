// The search that a space uses unless it is told otherwise: in a small space a table of all boxes, in others neighbours
// while few boxes move far, and all at once while many do.
//
// Which of them it is shows in the time that it takes, not in what is found.
#pragma once

#include <memory>

#include "collision/dxBatchSearch.h"
#include "collision/dxNeighbourSearch.h"
#include "collision/dxPairSearch.h"
#include "collision/dxTableSearch.h"

class dxAdaptiveSearch final : public dxPairSearch {
public:
    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    bool isTable() const { return m_table != nullptr; }
    bool isBatch() const { return m_batch != nullptr; }

private:
    void chooseTable(const dxMembers &members);
    void searchBatch(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);
    void searchNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);

    // One of them is there from the first call on.
    std::unique_ptr<dxTableSearch> m_table;
    std::unique_ptr<dxBatchSearch> m_batch;
    std::unique_ptr<dxNeighbourSearch> m_neighbours;
    int m_quietCalls = 0;  // in a row
};
