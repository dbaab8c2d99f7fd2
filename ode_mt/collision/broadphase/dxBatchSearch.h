// Finds the pairs of all members at once: for calls at which many have changed.
//
// Nothing is kept from call to call, so a call costs the same however far boxes have moved, and as much
// for members that rest.
//
// Members are put into levels by their longest edge, factors of two apart, each with a grid whose cells are as
// large as its boxes at most. Within a level boxes are sorted by cell and swept (overlap/dxCellSweep.h). Between
// levels the smaller boxes are sorted once more, by the cells of the larger ones, and swept against those; a
// handful of large boxes is compared with all smaller ones instead. Boxes that no cell can hold (infinite, NaN,
// inside out, astronomical) are compared with all.
//
// One call at a time; it may share its sweeps out.
#pragma once

#include <vector>

#include "collision/broadphase/dxBroadPhaseChoice.h"
#include "collision/broadphase/dxPairSearch.h"
#include "collision/broadphase/overlap/dxCellSweep.h"
#include "core/dxRadixSort.h"

class dxBatchSearch final : public dxPairSearch {
public:
    // Stops as soon as there are more pairs than that.
    explicit dxBatchSearch(dxPairLimit maxPairs = dxUnlimitedPairs) : m_maxPairs(maxPairs) {}

    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

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
    void searchLevel(const dxMembers &members, std::size_t level, dxTaskRunner &runner);
    void searchSmaller(const dxMembers &members, std::size_t level, const Grid &grid, dxTaskRunner &runner);
    void searchApart(const dxMembers &members, std::vector<Match> &matches);
    // Calls sweep(begin, end, matches) for pieces of the rows, until there are more matches than a space keeps.
    template <class Sweep>
    void sweepPieces(const dxCellRows &rows, dxTaskRunner &runner, const Sweep &sweep);

    const dxPairLimit m_maxPairs;
    std::size_t m_most = 0;            // matches of a worker, after which it stops
    std::vector<Level> m_byEdge;       // by exponent, from the lowest
    std::vector<Level *> m_levels;     // those in use, smallest boxes first
    dxBounds m_corners;                // the low ones of the boxes of a level and all smaller ones
    std::vector<Slot> m_apart;
    std::vector<Slot> m_smaller;
    dxCellRows m_smallerRows;
    std::vector<dxSortItem> m_items, m_spare;
    struct alignas(64) Found {
        std::vector<Match> matches;
    };
    std::vector<Found> m_found;  // by worker
};
