// The search that a space uses unless it is told otherwise: neighbours while few boxes move far, all at once
// while many do.
//
// Which of the two it is shows in the time that it takes, not in what is found.
#pragma once

#include <memory>

#include "collision/dxBatchSearch.h"
#include "collision/dxNeighbourSearch.h"
#include "collision/dxPairSearch.h"

class dxAdaptiveSearch final : public dxPairSearch {
public:
    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    bool isBatch() const { return m_batch != nullptr; }

private:
    void begin(const dxMembers &members);
    void searchBatch(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);
    void searchNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);

    // One of them is there from the first call on.
    std::unique_ptr<dxBatchSearch> m_batch;
    std::unique_ptr<dxNeighbourSearch> m_neighbours;
    int m_quietCalls = 0;  // in a row
};
