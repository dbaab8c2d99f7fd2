#include "ReferenceGrid.h"

#include <algorithm>
#include <cmath>

namespace {

// The constants of docs/clusters.md.
constexpr double kStrayShare = 0.02;
constexpr dReal kRoom = 1.5;
constexpr double kOutgrownShare = 0.12;

}  // namespace

int ReferenceCells::count() const {
    int product = 1;
    for (int axis = 0; axis < 3; ++axis) product *= high[axis] - low[axis] + 1;
    return product;
}

int ReferenceCells::gap(const ReferenceCells &other, int axis) const {
    return std::max({0, low[axis] - other.high[axis], other.low[axis] - high[axis]});
}

bool ReferenceCells::share(const ReferenceCells &other) const {
    return gap(other, 0) == 0 && gap(other, 1) == 0 && gap(other, 2) == 0;
}

bool ReferenceCells::touch(const ReferenceCells &other) const {
    return gap(other, 0) + gap(other, 1) + gap(other, 2) <= 1;
}

ReferenceGrid ReferenceGrid::around(const std::vector<dxBounds> &boxes, int cells) {
    ReferenceGrid grid;
    grid.m_cells = cells;
    dReal longest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<dReal> lows, highs;
        for (const dxBounds &box : boxes) {
            if (!box.isProper()) continue;
            lows.push_back(box.low(axis));
            highs.push_back(box.high(axis));
        }
        if (lows.empty()) continue;
        std::sort(lows.begin(), lows.end());
        std::sort(highs.rbegin(), highs.rend());
        const auto strays = static_cast<std::size_t>(std::floor(kStrayShare * static_cast<double>(lows.size())));
        const dReal low = lows[strays], high = highs[strays];
        grid.m_centre[axis] = low / 2 + high / 2;
        longest = std::max(longest, high - low);
    }
    if (longest > 0) grid.m_edge = longest * kRoom / dReal(cells);
    return grid;
}

bool ReferenceGrid::isOutgrownBy(const std::vector<dxBounds> &boxes) const {
    int proper = 0, outside = 0;
    for (const dxBounds &box : boxes) {
        if (!box.isProper()) continue;
        ++proper;
        bool isOutside = false;
        for (int axis = 0; axis < 3; ++axis) {
            const dReal corner = m_centre[axis] - m_edge * dReal(m_cells) / 2;
            isOutside = isOutside || box.low(axis) < corner || box.high(axis) > corner + m_edge * dReal(m_cells);
        }
        outside += isOutside;
    }
    return outside > kOutgrownShare * proper;
}

int ReferenceGrid::cellOf(dReal coordinate, int axis) const {
    const dReal corner = m_centre[axis] - m_edge * dReal(m_cells) / 2;
    const dReal cell = std::floor((coordinate - corner) / m_edge);
    if (cell < 0) return 0;
    return cell > dReal(m_cells - 1) ? m_cells - 1 : static_cast<int>(cell);
}

ReferenceCells ReferenceGrid::cellsOf(const dxBounds &box) const {
    ReferenceCells range;
    for (int axis = 0; axis < 3; ++axis) {
        const bool ordered = box.low(axis) <= box.high(axis);
        range.low[axis] = ordered ? cellOf(box.low(axis), axis) : 0;
        range.high[axis] = ordered ? cellOf(box.high(axis), axis) : m_cells - 1;
    }
    return range;
}
