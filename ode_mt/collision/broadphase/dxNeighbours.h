// For every box of a set its candidates, the boxes that it may overlap.
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
    void takeOut(Slot slot);
    void link(Slot a, Slot b);
    void unlinkAll(Slot slot);

    std::vector<Node> m_nodes;  // by slot
    dxHierarchicalGrid m_grid;
};
