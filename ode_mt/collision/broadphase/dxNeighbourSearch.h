// Pairs among neighbours: the search for calls at which few members have moved far.
#pragma once

#include "collision/broadphase/dxNeighbours.h"
#include "collision/broadphase/dxPairSearch.h"

class dxNeighbourSearch final : public dxPairSearch {
public:
    // Of members that did not change before the first search, if there are any.
    void adopt(const dxMembers &members);

    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    // Boxes that the last search had to look up in the grid; the others have neighbours that are known.
    std::size_t lookedUp() const { return m_lookedUp; }

private:
    void updateNeighbours(const dxMembers &members);

    dxNeighbours m_neighbours;
    std::vector<std::uint8_t> m_isKnown;  // by slot: is in m_neighbours
    std::size_t m_lookedUp = 0;
};
