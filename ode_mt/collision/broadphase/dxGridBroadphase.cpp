#include "collision/broadphase/dxGridBroadphase.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr int kLowestExponent = -40, kHighestExponent = 80;

// Maximum number of cells on an axis, so that numbers of cells are below 2^52, borders included. Boxes beyond are put into the last
// cell; so neighbours stay neighbours.
constexpr std::uint32_t kMaxCells = 1 << 17;

// A level is joined to the next larger one if that has more than this many boxes for each of its own: one sweep less.
constexpr std::size_t kSparse = 4;

// Maximum number of boxes of a level that are compared with all smaller ones, instead of sorting those again.
constexpr std::size_t kMaxComparedWithAll = 64;

// A chunk takes some ten microseconds.
constexpr std::size_t kRowsPerChunk = 256;

bool fitsACell(const dxBounds &box) {
    return box.isModerate() && box.longestEdge() < std::ldexp(1.0, kHighestExponent);
}

// Returns the exponent of the smallest cell that holds the box: 2^(exponent - 1) <= edge < 2^exponent.
int exponentOf(const dxBounds &box) {
    int exponent = kLowestExponent;
    const dReal edge = box.longestEdge();
    if (edge > 0) exponent = std::ilogb(edge) + 1;
    return std::max(exponent, kLowestExponent);
}

}  // namespace

dxCellStrides dxGridBroadphase::Grid::strides() const {
    const std::uint64_t y = cells[2] + 2;
    return {(cells[1] + 2) * y, y};
}

std::uint64_t dxGridBroadphase::Grid::cellOf(const dxBounds &box) const {
    std::uint64_t at[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double cell = std::floor(box.low(axis) * cellsPerUnit) - low[axis];
        at[axis] = 1 + static_cast<std::uint64_t>(std::min(cell, double(cells[axis] - 1)));
    }
    const dxCellStrides stride = strides();
    // There is one row and one layer more below, so that numbers of neighbours are never negative.
    return at[0] * stride.x + at[1] * stride.y + at[2];
}

void dxGridBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    m_maxMatches = m_maxPairs(members.end());
    sortIntoLevels(members);
    joinSparseLevels();
    if (m_found.size() < runner.workers()) m_found.resize(runner.workers());
    m_corners = dxBounds::nothing();
    for (std::size_t level = 0; level < m_levels.size(); ++level) findPairsOfLevel(members, level, runner);
    for (Found &found : m_found) {
        matches.insert(matches.end(), found.matches.begin(), found.matches.end());
        found.matches.clear();
    }
    findPairsApart(members, matches);
}

void dxGridBroadphase::sortIntoLevels(const dxMembers &members) {
    m_byEdge.resize(kHighestExponent - kLowestExponent + 1);
    for (Level *const level : m_levels) level->slots.clear();
    m_levels.clear();
    m_apart.clear();
    for (Slot slot = 0; slot < members.end(); ++slot) {
        if (members[slot].geom == nullptr) continue;
        const dxBounds &box = members[slot].bounds;
        if (!fitsACell(box)) {
            m_apart.push_back(slot);
            continue;
        }
        const int exponent = exponentOf(box);
        Level &level = m_byEdge[static_cast<std::size_t>(exponent - kLowestExponent)];
        level.exponent = exponent;
        if (level.slots.empty()) m_levels.push_back(&level);
        level.slots.push_back(slot);
    }
    std::sort(m_levels.begin(), m_levels.end(), [](const Level *a, const Level *b) { return a->exponent < b->exponent; });
}

void dxGridBroadphase::joinSparseLevels() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_levels.size(); ++i) {
        std::vector<Slot> &slots = m_levels[i]->slots;
        const bool isSparse = i + 1 < m_levels.size() && slots.size() * kSparse < m_levels[i + 1]->slots.size();
        if (isSparse) {
            std::vector<Slot> &next = m_levels[i + 1]->slots;
            next.insert(next.end(), slots.begin(), slots.end());
            slots.clear();
        } else {
            m_levels[kept++] = m_levels[i];
        }
    }
    m_levels.resize(kept);
}

// Returns the grid of the corners so far. Cells are enlarged where boxes lie so far apart that there would be too many.
dxGridBroadphase::Grid dxGridBroadphase::gridOf(int exponent) const {
    const double extent = m_corners.longestEdge();
    if (extent > 0) exponent = std::max(exponent, std::ilogb(extent / kMaxCells) + 2);
    Grid grid;
    grid.cellsPerUnit = std::ldexp(1.0, -exponent);
    for (int axis = 0; axis < 3; ++axis) {
        grid.low[axis] = std::floor(m_corners.low(axis) * grid.cellsPerUnit);
        const double cells = std::floor(m_corners.high(axis) * grid.cellsPerUnit) - grid.low[axis] + 1;
        grid.cells[axis] = static_cast<std::uint32_t>(std::min(cells, double(kMaxCells)));
    }
    return grid;
}

void dxGridBroadphase::fillRows(const dxMembers &members, const Grid &grid, const std::vector<Slot> &slots,
                             dxCellRows &rows) {
    m_items.clear();
    for (std::uint32_t i = 0; i < slots.size(); ++i) m_items.push_back({grid.cellOf(members[slots[i]].bounds), i});
    dxRadixSort(m_items, m_spare);
    rows.resize(m_items.size());
    for (std::size_t row = 0; row < m_items.size(); ++row) {
        const Slot slot = slots[m_items[row].index];
        rows.set(row, m_items[row].key, slot, members[slot].bounds, members.isChanged(slot));
    }
}

void dxGridBroadphase::findPairsOfLevel(const dxMembers &members, std::size_t index, dxTaskRunner &runner) {
    Level &level = *m_levels[index];
    for (const Slot slot : level.slots) {
        const dxBounds &box = members[slot].bounds;
        for (int axis = 0; axis < 3; ++axis) m_corners.includeOn(axis, box.low(axis), box.low(axis));
    }
    const Grid grid = gridOf(level.exponent);
    fillRows(members, grid, level.slots, level.rows);
    pairsByChunks(level.rows, runner, [&](std::size_t begin, std::size_t end, std::vector<Match> &matches) {
        dxCellPairsWithin(level.rows, grid.strides(), begin, end, matches);
    });
    if (index > 0) findPairsWithSmaller(members, index, grid, runner);
}

void dxGridBroadphase::findPairsWithSmaller(const dxMembers &members, std::size_t index, const Grid &grid,
                                  dxTaskRunner &runner) {
    const Level &level = *m_levels[index];
    if (level.slots.size() <= kMaxComparedWithAll) {
        for (std::size_t smaller = 0; smaller < index; ++smaller)
            for (const Slot slot : level.slots)
                dxCellPairsOfBox(m_levels[smaller]->rows, members[slot].bounds, slot, members.isChanged(slot),
                           m_found[0].matches);
        return;
    }
    m_smaller.clear();
    for (std::size_t smaller = 0; smaller < index; ++smaller)
        m_smaller.insert(m_smaller.end(), m_levels[smaller]->slots.begin(), m_levels[smaller]->slots.end());
    fillRows(members, grid, m_smaller, m_smallerRows);
    pairsByChunks(level.rows, runner, [&](std::size_t begin, std::size_t end, std::vector<Match> &matches) {
        dxCellPairsAcross(level.rows, m_smallerRows, grid.strides(), begin, end, matches);
    });
}

template <class Sweep>
void dxGridBroadphase::pairsByChunks(const dxCellRows &rows, dxTaskRunner &runner, const Sweep &sweep) {
    runner.forChunks(dxParallelStage::CellGridPairs, rows.size(), kRowsPerChunk,
        [&](std::size_t begin, std::size_t end, unsigned worker) {
        std::vector<Match> &matches = m_found[worker].matches;
        if (matches.size() <= m_maxMatches) sweep(begin, end, matches);
    });
}

void dxGridBroadphase::findPairsApart(const dxMembers &members, std::vector<Match> &matches) {
    for (std::size_t i = 0; i < m_apart.size(); ++i) {
        const Slot slot = m_apart[i];
        const dxBounds &box = members[slot].bounds;
        for (const Level *const level : m_levels)
            dxCellPairsOfBox(level->rows, box, slot, members.isChanged(slot), matches);
        for (std::size_t j = i + 1; j < m_apart.size(); ++j) {
            const Slot other = m_apart[j];
            if (!members.areUnchanged(slot, other) && box.overlaps(members[other].bounds)) matches.push_back({slot, other});
        }
        if (matches.size() > m_maxMatches) return;
    }
}
