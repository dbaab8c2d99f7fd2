// The grid of the cluster algorithms (thesis chapters 2 and 10): n x n x n cubic cells around a centre.
//
// Everything outside belongs to the border cells. Rounding a bound to its cell and clamping it to the border are
// monotonic, so two boxes that overlap always share a cell: the grid affects how well clusters are separated, never
// whether a pair is found.
#pragma once

#include <cstdint>

#include "core/dxBounds.h"
#include "settings/dxSettings.h"

struct dxCellRange {
    std::int16_t low[3], high[3];

    bool operator==(const dxCellRange &o) const {
        for (int axis = 0; axis < 3; ++axis)
            if (low[axis] != o.low[axis] || high[axis] != o.high[axis]) return false;
        return true;
    }
    int count() const {
        return (high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1);
    }
};

class dxClusterGrid {
public:
    static constexpr int kMinCells = dxSettings::kMinGridCells, kMaxCells = dxSettings::kMaxGridCells;  // an axis

    dxClusterGrid() = default;
    // `cells` on each axis; `edge` of a cell, above 0.
    dxClusterGrid(int cells, dReal edge, const dReal centre[3]);

    int cells() const { return m_cells; }
    int cellCount() const { return m_cells * m_cells * m_cells; }
    dReal edge() const { return m_edge; }
    const dReal *centre() const { return m_centre; }

    // Returns the cells that a box covers. On an axis on which a bound is NaN or min > max these are all cells: NaN overlaps everything, and an
    // inverted box overlaps those that extend from its max to its min.
    dxCellRange cellsOf(const dxBounds &box) const;
    // Returns whether the box extends beyond the grid on some side.
    bool isLeftBy(const dxBounds &box) const;

    int index(int x, int y, int z) const { return (x * m_cells + y) * m_cells + z; }

    template <class Visit>
    void forCells(const dxCellRange &range, Visit &&visit) const {
        for (int x = range.low[0]; x <= range.high[0]; ++x)
            for (int y = range.low[1]; y <= range.high[1]; ++y)
                for (int z = range.low[2]; z <= range.high[2]; ++z) visit(index(x, y, z));
    }

private:
    int cellOf(dReal coordinate, int axis) const;

    int m_cells = 1;
    dReal m_edge = 1;
    dReal m_centre[3] = {0, 0, 0};
    dReal m_corner[3] = {0, 0, 0};
};
