// All pairs of overlapping boxes among boxes sorted by cells: the inner loop of the grid broad phase, with SIMD.
//
// Space is cut into cubic cells, numbered so that z runs fastest and no cell follows a border of the region directly:
// the neighbours of cell c are c + i strideX + j strideY + k with i, j, k of -1, 0 and 1. A box is in the cell of its
// lowest corner. If no box is longer than a cell, two that overlap are in the same cell or in neighbouring ones. So the
// candidates of a box are nine short runs of rows, one for each (i, j), and as rows are taken in order the runs only
// move forward: no lookup is needed. Source of the idea: linked-cell lists of molecular dynamics (Hockney and Eastwood,
// Computer Simulation Using Particles, 8.4), sorted instead of linked.
//
// Runs are short and their lengths unpredictable, so a run's end is found as a mask, not by a branch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxPair.h"
#include "core/dxBounds.h"

// Boxes in rising order of their cells, in columns. Numbers of cells are below 2^52, so that a double holds them and
// vectors of bounds and of cells have as many lanes.
class dxCellRows {
public:
    static constexpr int kColumns = 7;  // six bounds and the cell

    std::size_t size() const { return m_slots.size(); }
    const double *bound(int i) const { return m_columns[i].data(); }
    const double *cells() const { return m_columns[6].data(); }
    std::uint32_t slot(std::size_t row) const { return m_slots[row]; }
    // Pairs of two unchanged boxes are skipped.
    bool isChanged(std::size_t row) const { return m_isChanged[row] != 0; }

    void resize(std::size_t rows);
    void set(std::size_t row, std::uint64_t cell, std::uint32_t slot, const dxBounds &box, bool changed) {
        for (int i = 0; i < 6; ++i) m_columns[i][row] = box.v[i];
        m_columns[6][row] = static_cast<double>(cell);
        m_slots[row] = slot;
        m_isChanged[row] = changed;
    }

private:
    std::vector<double> m_columns[kColumns];  // longer than the table; behind its end no cell is ever reached
    std::vector<std::uint32_t> m_slots;
    std::vector<std::uint8_t> m_isChanged;
};

struct dxCellStrides {
    std::uint64_t x, y;
};

// Appends the pairs of rows of one table, the earlier of which is in [begin, end).
void dxCellPairsWithin(const dxCellRows &rows, dxCellStrides strides, std::size_t begin, std::size_t end,
                   std::vector<dxSlotPair> &pairs);

// Appends the pairs of one row of `outer` in [begin, end) and one of `inner`; both have cells of the same grid.
void dxCellPairsAcross(const dxCellRows &outer, const dxCellRows &inner, dxCellStrides strides, std::size_t begin,
                   std::size_t end, std::vector<dxSlotPair> &pairs);

// Appends the pairs of `box` and any row.
void dxCellPairsOfBox(const dxCellRows &rows, const dxBounds &box, std::uint32_t slot, bool changed,
                std::vector<dxSlotPair> &pairs);
