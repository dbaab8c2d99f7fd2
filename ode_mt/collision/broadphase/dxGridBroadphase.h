// Broad phase by cell grids, for calls in which many members have changed.
//
// It keeps no state from call to call, so the cost of a call does not depend on how far boxes have moved, and includes
// the members at rest.
//
// Members are assigned to levels by their longest edge, in powers of two. Each level has a grid whose cells are at
// least as large as its boxes. Within a level boxes are sorted by cell and compared with neighbouring cells
// (overlap/dxCellGridPairs.h). Between levels the smaller boxes are sorted once more, by the cells of the larger ones, and
// compared with those; a few large boxes are compared with all smaller ones instead. Boxes that no cell can hold
// (infinite, NaN, min > max, above 1e30) are compared with all.
//
// Source of the idea: the cell lists of molecular dynamics (Allen and Tildesley, Computer Simulation of Liquids, 5.3).
//
// Threading: one call at a time, whose chunks of rows may run on workers.
#pragma once

#include <vector>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/overlap/dxCellGridPairs.h"
#include "core/dxCacheLine.h"
#include "core/dxRadixSort.h"

class dxGridBroadphase final : public dxBroadphase {
public:
    // A call stops as soon as there are more pairs than `maxPairs` allows.
    explicit dxGridBroadphase(dxPairLimit maxPairs = dxUnlimitedPairs) : m_maxPairs(maxPairs) {}

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

private:
    using Slot = dxMembers::Slot;

    struct Level {
        int exponent = 0;  // cells of edge 2^exponent
        std::vector<Slot> slots;
        dxCellRows rows;
    };

    // The grid of a level over boxes of that level and smaller ones.
    struct Grid {
        double cellsPerUnit, low[3];
        std::uint32_t cells[3];

        dxCellStrides strides() const;
        std::uint64_t cellOf(const dxBounds &box) const;
    };

    void sortIntoLevels(const dxMembers &members);
    void joinSparseLevels();
    Grid gridOf(int exponent) const;
    void fillRows(const dxMembers &members, const Grid &grid, const std::vector<Slot> &slots, dxCellRows &rows);
    void findPairsOfLevel(const dxMembers &members, std::size_t level, dxTaskRunner &runner);
    void findPairsWithSmaller(const dxMembers &members, std::size_t level, const Grid &grid, dxTaskRunner &runner);
    void findPairsApart(const dxMembers &members, std::vector<Match> &matches);
    // Calls sweep(begin, end, matches) for chunks of the rows, until there are more matches than a space keeps.
    template <class Sweep>
    void pairsByChunks(const dxCellRows &rows, dxTaskRunner &runner, const Sweep &sweep);

    const dxPairLimit m_maxPairs;
    std::size_t m_maxMatches = 0;      // number of matches of a worker after which it stops
    std::vector<Level> m_byEdge;       // by exponent, from the lowest
    std::vector<Level *> m_levels;     // those in use, smallest boxes first
    dxBounds m_corners;                // the low ones of the boxes of a level and all smaller ones
    std::vector<Slot> m_apart;
    std::vector<Slot> m_smaller;
    dxCellRows m_smallerRows;
    std::vector<dxSortItem> m_items, m_spare;
    struct alignas(kCacheLine) Found {
        std::vector<Match> matches;
    };
    std::vector<Found> m_found;  // by worker
};
