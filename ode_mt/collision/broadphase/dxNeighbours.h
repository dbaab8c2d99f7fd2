// Who is near whom: for every box of a set its candidates, the boxes that it may overlap.
//
// Each box is stored with a margin. While it moves within the margin, its candidates stay what they are and
// a frame costs it one comparison; when it leaves, it is looked up again (dxLevelGrid). Two boxes that
// overlap are always candidates of each other, because each lies within its stored box.
//
// Not thread safe for changes; candidates may be read from several threads.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broadphase/dxLevelGrid.h"
#include "core/dxBounds.h"

class dxNeighbours {
public:
    using Slot = dxLevelGrid::Slot;

    struct Candidate {
        Slot slot;
        std::uint32_t back;  // where this box stands among the candidates of that one
    };

    void insert(Slot slot, const dxBounds &box);
    // True: the box left its margin and was looked up again.
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
    dxLevelGrid m_grid;
};
