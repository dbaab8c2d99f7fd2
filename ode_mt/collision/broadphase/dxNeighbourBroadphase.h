// Broad phase by neighbours with margins, for calls in which few members have moved far.
#pragma once

#include "collision/broadphase/dxNeighbours.h"
#include "collision/broadphase/dxBroadphase.h"

class dxNeighbourBroadphase final : public dxBroadphase {
public:
    // Takes over members that have not changed before the first call.
    void adopt(const dxMembers &members);

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    // Returns the number of boxes that the last call queried in the grid; the neighbours of the others are known.
    std::size_t lookedUp() const { return m_lookedUp; }

private:
    void updateNeighbours(const dxMembers &members);

    dxNeighbours m_neighbours;
    std::vector<std::uint8_t> m_isKnown;  // by slot: is in m_neighbours
    std::size_t m_lookedUp = 0;
};
