#include "clusters/dxClusterScene.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using Kind = dxClusterScene::Kind;

// Share of the dynamic inhabitants that may lie beyond either end of an axis of the grid.
constexpr double kOutliers = 0.02;
// A grid is outgrown when more than this share is outside: more than a fit leaves.
constexpr double kMaxOutside = 6 * kOutliers;
// The grid is this many times as long as the extent of the dynamic inhabitants.
constexpr dReal kRelativeSize = 1.5;

// A floor, one layer of cells, is big; a wall along the whole grid, one cell thick and a few high, is not.
bool coversALayer(const dxCellRange &range, int cells) { return range.count() > cells * cells / 2; }

void eraseFrom(std::vector<dxMembers::Slot> &slots, dxMembers::Slot slot) {
    *std::find(slots.begin(), slots.end(), slot) = slots.back();
    slots.pop_back();
}

template <class Visit>
void forDynamics(const dxClusterScene &scene, Visit &&visit) {
    for (dxClusterScene::Slot slot = 0; slot < scene.end(); ++slot)
        if (scene[slot].kind == Kind::dynamicGeom && scene[slot].bounds.isProper()) visit(scene[slot].bounds);
}

struct Extent {
    dReal low = 0, high = 0;
};

Extent extentOf(std::vector<dReal> &lows, std::vector<dReal> &highs) {
    const auto outliers = static_cast<std::ptrdiff_t>(kOutliers * static_cast<double>(lows.size()));
    std::nth_element(lows.begin(), lows.begin() + outliers, lows.end());
    std::nth_element(highs.begin(), highs.end() - 1 - outliers, highs.end());
    return {lows[outliers], *(highs.end() - 1 - outliers)};
}

}  // namespace

void dxClusterScene::setGrid(const dxClusterGrid &grid) {
    m_grid = grid;
    m_cells.assign(grid.cellCount(), {});
    m_occupied.clear();
    m_whereOccupied.assign(grid.cellCount(), -1);
    for (auto &list : m_all) list.clear();
    m_big.clear();
    for (Slot slot = 0; slot < end(); ++slot) {
        Inhabitant &inhabitant = m_inhabitants[slot];
        if (inhabitant.kind == Kind::none) continue;
        inhabitant.cells = m_grid.cellsOf(inhabitant.bounds);
        enter(slot);
    }
}

void dxClusterScene::put(Slot slot, Kind kind, const dxBounds &bounds) {
    if (slot >= m_inhabitants.size()) m_inhabitants.resize(slot + 1);
    Inhabitant &inhabitant = m_inhabitants[slot];
    const dxCellRange cells = m_grid.cellsOf(bounds);
    inhabitant.bounds = bounds;
    if (inhabitant.kind == kind && inhabitant.cells == cells && inhabitant.big == isBig(cells, bounds)) return;
    if (inhabitant.kind != Kind::none) leave(slot);
    inhabitant.kind = kind;
    inhabitant.cells = cells;
    enter(slot);
}

void dxClusterScene::remove(Slot slot) {
    if (slot >= m_inhabitants.size() || m_inhabitants[slot].kind == Kind::none) return;
    leave(slot);
    m_inhabitants[slot].kind = Kind::none;
}

bool dxClusterScene::isBig(const dxCellRange &cells, const dxBounds &bounds) const {
    return !bounds.isProper() || coversALayer(cells, m_grid.cells());
}

void dxClusterScene::enter(Slot slot) {
    ++m_changes;
    Inhabitant &inhabitant = m_inhabitants[slot];
    inhabitant.big = isBig(inhabitant.cells, inhabitant.bounds);
    std::vector<Slot> &list = inhabitant.big ? m_big : m_all[place(inhabitant.kind)];
    inhabitant.listed = static_cast<std::uint32_t>(list.size());
    list.push_back(slot);
    if (inhabitant.big) return;
    m_grid.forCells(inhabitant.cells, [&](int cell) {
        std::vector<Slot> &inCell = m_cells[cell][place(inhabitant.kind)];
        if (inCell.empty() && inhabitant.kind == Kind::dynamicGeom) {
            m_whereOccupied[cell] = static_cast<int>(m_occupied.size());
            m_occupied.push_back(cell);
        }
        inCell.push_back(slot);
    });
}

void dxClusterScene::leave(Slot slot) {
    ++m_changes;
    const Inhabitant inhabitant = m_inhabitants[slot];
    std::vector<Slot> &list = inhabitant.big ? m_big : m_all[place(inhabitant.kind)];
    list[inhabitant.listed] = list.back();
    m_inhabitants[list.back()].listed = inhabitant.listed;
    list.pop_back();
    if (inhabitant.big) return;
    m_grid.forCells(inhabitant.cells, [&](int cell) {
        std::vector<Slot> &inCell = m_cells[cell][place(inhabitant.kind)];
        eraseFrom(inCell, slot);
        if (!inCell.empty() || inhabitant.kind != Kind::dynamicGeom) return;
        const int where = m_whereOccupied[cell];
        m_occupied[where] = m_occupied.back();
        m_whereOccupied[m_occupied.back()] = where;
        m_occupied.pop_back();
        m_whereOccupied[cell] = -1;
    });
}

dxClusterGrid dxFitGrid(const dxClusterScene &scene, int cells) {
    std::vector<dReal> lows[3], highs[3];
    forDynamics(scene, [&](const dxBounds &box) {
        for (int axis = 0; axis < 3; ++axis) {
            lows[axis].push_back(box.low(axis));
            highs[axis].push_back(box.high(axis));
        }
    });
    dReal centre[3] = {0, 0, 0}, longest = 0;
    for (int axis = 0; axis < 3 && !lows[axis].empty(); ++axis) {
        const Extent extent = extentOf(lows[axis], highs[axis]);
        centre[axis] = extent.low / 2 + extent.high / 2;
        longest = std::max(longest, extent.high - extent.low);
    }
    const dReal edge = longest * kRelativeSize / dReal(cells);
    const bool usable = std::isfinite(edge) && edge > 0;
    return dxClusterGrid(cells, usable ? edge : dReal(1), centre);
}

double dxShareOutside(const dxClusterScene &scene) {
    std::size_t all = 0, outside = 0;
    forDynamics(scene, [&](const dxBounds &box) {
        ++all;
        outside += scene.grid().isLeftBy(box);
    });
    return all > 0 ? static_cast<double>(outside) / static_cast<double>(all) : 0;
}

bool dxGridIsOutgrown(const dxClusterScene &scene) { return dxShareOutside(scene) > kMaxOutside; }
