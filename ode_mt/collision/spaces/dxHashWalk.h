// One call of a hash space done cell by cell as upstream does it, for the cases in which pairs are not kept:
// too many of them, boxes that are not up to date, a call inside another one.
//
// In memory for the geoms and the cells that they cover, at most eight each; upstream keeps a bit for every
// two geoms, too. docs/collision-order.md.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/collision_space.h>

#include "collision/pairs/dxOrderedPair.h"
#include "collision/spaces/dxHashCells.h"

class dxHashWalk {
public:
    // In the order of the list; all are enabled, and none is out of range.
    void add(dxGeom *geom, const dxHashCells &cells);
    // After the last geom: takes what memory deliver() needs.
    void storeAll();
    // The callbacks, from the first one on or from behind a pair. What callbacks add to the space is not
    // seen.
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
