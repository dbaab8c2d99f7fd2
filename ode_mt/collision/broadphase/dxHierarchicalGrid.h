// A hierarchical hash grid of boxes that is kept from frame to frame, for queries of the boxes near a box.
//
// A box is stored on the level whose cells are just as large as it (cell edge 2^level, at most two cells per axis, so
// at most eight). A query visits the cells that it covers on every level in use. The cost of insertion, removal and
// query depends on the neighbourhood only, not on the number or sizes of all boxes. Boxes that no cell can hold
// (infinite, NaN, min > max, out of the range of cell numbers) are kept apart and visited by every query.
//
// Boxes are identified by slots, small numbers that the owner assigns. Threading: not thread-safe. Source of the idea:
// Ericson, Real-Time Collision Detection, 7.1.5 "Hierarchical Grids".
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/dxBounds.h"
#include "core/dxNoIndex.h"

class dxHierarchicalGrid {
public:
    using Slot = std::uint32_t;

    void insert(Slot slot, const dxBounds &box);
    void remove(Slot slot);

    // Calls visit(slot) once for every box that may overlap `box`; the caller compares. `box` may be a
    // stored one, which is visited too.
    template <class Visit>
    void query(const dxBounds &box, Visit &&visit) const;

    // Number of cells, empty ones included, for tests of bounded memory.
    std::size_t cellCount() const { return m_cells.size(); }

private:
    static constexpr int kLowestLevel = -40, kHighestLevel = 80;
    static constexpr int kApart = kHighestLevel + 1;  // "level" of boxes that no cell can hold

    struct Cell {
        std::int32_t level, x, y, z;
        std::uint32_t first;  // entry, or kNoIndex
    };
    struct Entry {
        Slot slot;
        std::uint32_t next;
    };
    struct Range {
        std::int32_t low[3], high[3];
    };
    struct Place {
        int level;
        Range cells;
        std::uint32_t indexInLevel;
    };

    static int levelOf(const dxBounds &box);
    template <class Visit>
    static void forCells(const Range &range, Visit &&visit) {
        for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x)
            for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y)
                for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z) visit(x, y, z);
    }
    // Returns false if the box covers cells whose numbers do not fit.
    static bool cellsOf(const dxBounds &box, int level, Range &range);
    static std::size_t hashOf(std::int32_t level, std::int32_t x, std::int32_t y, std::int32_t z);

    std::vector<Slot> &members(int level) { return m_levels[level - kLowestLevel]; }
    const std::vector<Slot> &members(int level) const { return m_levels[level - kLowestLevel]; }
    const Cell *find(std::int32_t level, std::int32_t x, std::int32_t y, std::int32_t z) const;
    Cell &findOrMake(std::int32_t level, std::int32_t x, std::int32_t y, std::int32_t z);
    void rebuildTable();
    void enterCells(Slot slot, const Place &place);
    void leaveCells(Slot slot, const Place &place);
    template <class Visit>
    void queryLevel(int level, const dxBounds &box, Visit &visit) const;

    std::vector<Cell> m_cells;                // open addressing, a power of two
    std::size_t m_usedCells = 0;              // with a key, empty or not
    std::vector<Entry> m_entries;
    std::uint32_t m_freeEntry = kNoIndex;
    std::vector<Place> m_places;              // by slot
    std::array<std::vector<Slot>, kApart - kLowestLevel + 1> m_levels;
    std::vector<int> m_levelsInUse;
};

template <class Visit>
void dxHierarchicalGrid::query(const dxBounds &box, Visit &&visit) const {
    for (const int level : m_levelsInUse) queryLevel(level, box, visit);
}

template <class Visit>
void dxHierarchicalGrid::queryLevel(int level, const dxBounds &box, Visit &visit) const {
    const std::vector<Slot> &all = members(level);
    Range range;
    bool byCells = level != kApart && box.isProper() && cellsOf(box, level, range);
    if (byCells) {
        double cells = 1;
        for (int axis = 0; axis < 3; ++axis)
            cells *= static_cast<double>(range.high[axis]) - range.low[axis] + 1;
        byCells = cells < static_cast<double>(all.size());
    }
    if (!byCells) {
        for (const Slot slot : all) visit(slot);
        return;
    }
    forCells(range, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        const Cell *const cell = find(level, x, y, z);
        if (cell == nullptr) return;
        for (std::uint32_t e = cell->first; e != kNoIndex; e = m_entries[e].next) {
            // A pair may share several cells: it is reported in the first of them only.
            const Range &other = m_places[m_entries[e].slot].cells;
            if (x == std::max(range.low[0], other.low[0]) && y == std::max(range.low[1], other.low[1]) &&
                z == std::max(range.low[2], other.low[2]))
                visit(m_entries[e].slot);
        }
    });
}
