// Pairs among neighbours: the search for spaces of any size.
#pragma once

#include "collision/dxNeighbours.h"
#include "collision/dxPairSearch.h"

class dxNeighbourSearch final : public dxPairSearch {
public:
    void search(const dxMembers &members, std::vector<Match> &matches) override;

private:
    void updateNeighbours(const dxMembers &members);

    dxNeighbours m_neighbours;
    std::vector<std::uint8_t> m_isKnown;  // by slot: is in m_neighbours
};
