// A broad phase by neighbours with margins, for calls in which few members have moved far; and the neighbours themselves: for every box of a set its
// candidates, the boxes that it may overlap.
//
// Each box is stored with a margin. While it moves within the margin, its candidates are unchanged and a frame costs
// one comparison; when it leaves the margin, it is queried again (dxHierarchicalGrid). Two boxes that overlap are always
// candidates of each other, because each lies within its stored box. Box2D's b2DynamicTree stores boxes with a margin for the same
// reason.
//
// Threading: changes are not thread-safe; several threads may read candidates.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/dxHierarchicalGrid.h"
#include "core/dxBounds.h"

class dxNeighbours {
public:
    using Slot = dxHierarchicalGrid::Slot;

    struct Candidate {
        Slot slot;
        std::uint32_t back;  // index of this box among the candidates of that one
    };

    void insert(Slot slot, const dxBounds &box);
    // Returns whether the box left its margin and was queried again.
    bool move(Slot slot, const dxBounds &box);
    void remove(Slot slot);

    const std::vector<Candidate> &of(Slot slot) const { return m_nodes[slot].candidates; }

private:
    struct Node {
        dxBounds last;    // the box itself
        dxBounds stored;  // the box with its margin
        std::vector<Candidate> candidates;
    };

    void store(Slot slot, const dxBounds &stored);
    void link(Slot a, Slot b);
    void unlinkAll(Slot slot);

    std::vector<Node> m_nodes;  // by slot
    dxHierarchicalGrid m_grid;
};

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
