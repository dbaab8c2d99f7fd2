// One call of a hash space, cell by cell as in upstream, for the cases in which pairs are not kept: too many pairs,
// boxes that are not up to date, a nested call.
//
// It needs memory for the geoms and the cells that they cover, at most eight each; upstream also keeps a bit for every
// two geoms. docs/collision.md.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/collision_space.h>

#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxHashCells.h"

class dxHashWalk {
public:
    // Adds a geom. Requires the order of the list, enabled geoms, and none out of range.
    void add(dxGeom *geom, const dxHashCells &cells);
    // Allocates the memory of deliver(). Requires a call after the last geom.
    void storeAll();
    // Calls the callbacks, from the first pair on or from behind a pair. Geoms that callbacks add to the space are
    // ignored.
    void deliver(void *data, dNearCallback *callback, const dxOrderedPair *after);

private:
    using Cell = dxHashCells::Cell;

    struct Boxed {
        dxGeom *geom;
        dxHashCells cells;
    };
    struct StoredCell {
        Cell cell;
        int level;
        std::uint32_t last;    // of its nodes
        std::uint32_t before;  // the cell stored before it in the same bucket
    };
    struct Node {
        std::uint32_t boxed;
        std::uint32_t before;  // the node stored before it in the same cell
    };
    // Calls back, once it is behind the pair to begin after.
    struct Meeting;

    void store(std::uint32_t boxed, const Cell &cell);
    std::uint32_t find(const Cell &cell, int level) const;
    std::size_t bucketOf(const Cell &cell, int level) const;
    void search(std::uint32_t searcher, Meeting &meeting);

    std::vector<Boxed> m_inTable;
    std::vector<std::uint32_t> m_foundBy;  // the geom that found each of m_inTable last
    std::vector<dxGeom *> m_big;
    std::vector<StoredCell> m_cells;
    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_buckets;  // the cell stored last in each
    int m_highestLevel = 0;
};
