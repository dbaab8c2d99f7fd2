// Where the grid lies and which cells a box covers, computed plainly from the rules of docs/clusters.md, for
// comparison with dxClusterGrid and dxFitGrid.
#pragma once

#include <vector>

#include <ode/ode.h>

#include "core/dxBounds.h"

struct ReferenceCells {
    int low[3], high[3];

    int count() const;
    // How far apart on an axis, 0 if they have cells in common there.
    int gap(const ReferenceCells &other, int axis) const;
    bool share(const ReferenceCells &other) const;
    // They share a cell, or a cell of the one has a face in common with a cell of the other.
    bool touch(const ReferenceCells &other) const;
};

class ReferenceGrid {
public:
    // Around these boxes, of which those that are not proper do not count.
    static ReferenceGrid around(const std::vector<dxBounds> &boxes, int cells);

    bool isOutgrownBy(const std::vector<dxBounds> &boxes) const;
    ReferenceCells cellsOf(const dxBounds &box) const;
    int cells() const { return m_cells; }
    dReal edge() const { return m_edge; }
    dReal centre(int axis) const { return m_centre[axis]; }

private:
    int cellOf(dReal coordinate, int axis) const;

    int m_cells = 0;
    dReal m_edge = 1, m_centre[3] = {0, 0, 0};
};
