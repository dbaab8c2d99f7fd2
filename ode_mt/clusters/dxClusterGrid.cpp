#include "clusters/dxClusterGrid.h"

#include <algorithm>

dxClusterGrid::dxClusterGrid(int cells, dReal edge, const dReal centre[3]) : m_cells(cells), m_edge(edge) {
    for (int axis = 0; axis < 3; ++axis) {
        m_centre[axis] = centre[axis];
        m_corner[axis] = centre[axis] - edge * dReal(cells) / 2;
    }
}

int dxClusterGrid::cellOf(dReal coordinate, int axis) const {
    const dReal cell = dFloor((coordinate - m_corner[axis]) / m_edge);
    if (!(cell > 0)) return 0;  // also where infinities have no difference
    return static_cast<int>(std::min(cell, dReal(m_cells - 1)));
}

dxCellRange dxClusterGrid::cellsOf(const dxBounds &box) const {
    dxCellRange range;
    for (int axis = 0; axis < 3; ++axis) {
        const bool ordered = box.low(axis) <= box.high(axis);
        range.low[axis] = static_cast<std::int16_t>(ordered ? cellOf(box.low(axis), axis) : 0);
        range.high[axis] = static_cast<std::int16_t>(ordered ? cellOf(box.high(axis), axis) : m_cells - 1);
    }
    return range;
}

bool dxClusterGrid::isLeftBy(const dxBounds &box) const {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.low(axis) >= m_corner[axis] && box.high(axis) <= m_corner[axis] + m_edge * dReal(m_cells)))
            return true;
    return false;
}
