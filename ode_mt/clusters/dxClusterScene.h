// The input of the crossover passes: the inhabitants of each cell of the grid, and where the grid should lie. The scene is kept from frame to
// frame; the cost of a frame is proportional to what has changed.
//
// An inhabitant is a geom of the space (a geom or a nested space) and is known by its slot. It is dynamic if
// it, or a geom in it, has a body, else static (thesis 5.1). Big ones, planes and everything that covers
// more than a share of the grid, are in no cell and are kept apart (thesis 2.2).
//
// The grid is placed around the dynamic inhabitants (thesis 10.1: the grid's centre). Static ones do not enlarge it, and neither do a few outliers.
//
// Threading: not thread-safe.
#pragma once

#include <array>
#include <vector>

#include "clusters/dxClusterGrid.h"
#include "collision/pairs/dxMembers.h"

class dxClusterScene {
public:
    using Slot = dxMembers::Slot;

    enum class Kind : std::uint8_t { none, dynamicGeom, staticGeom };
    static constexpr int kKinds = 2;  // that may be somewhere: dynamic, static

    struct Inhabitant {
        Kind kind = Kind::none;
        bool big = false;
        dxCellRange cells;
        dxBounds bounds;
        std::uint32_t listed;  // its index in its list (all, or big)
    };

    void setGrid(const dxClusterGrid &grid);
    const dxClusterGrid &grid() const { return m_grid; }

    void put(Slot slot, Kind kind, const dxBounds &bounds);
    void remove(Slot slot);

    Slot end() const { return static_cast<Slot>(m_inhabitants.size()); }
    const Inhabitant &operator[](Slot slot) const { return m_inhabitants[slot]; }
    const std::vector<Slot> &all(Kind kind) const { return m_all[place(kind)]; }
    const std::vector<Slot> &big() const { return m_big; }
    const std::vector<Slot> &in(int cell, Kind kind) const { return m_cells[cell][place(kind)]; }
    // Cells with dynamic inhabitants, in no order.
    const std::vector<int> &occupied() const { return m_occupied; }

    // Returns a counter that rises whenever an inhabitant is added, is removed, or changes its kind or its cells.
    unsigned changes() const { return m_changes; }

private:
    static std::size_t place(Kind kind) { return kind == Kind::dynamicGeom ? 0 : 1; }
    bool isBig(const dxCellRange &cells, const dxBounds &bounds) const;
    void enter(Slot slot);
    void leave(Slot slot);

    dxClusterGrid m_grid;
    std::vector<Inhabitant> m_inhabitants;  // by slot
    std::array<std::vector<Slot>, kKinds> m_all;
    std::vector<Slot> m_big;
    std::vector<std::array<std::vector<Slot>, kKinds>> m_cells;
    std::vector<int> m_occupied, m_whereOccupied;  // m_whereOccupied: by cell, -1 if none
    unsigned m_changes = 0;
};

// Returns a grid of `cells` cells on each axis around the dynamic inhabitants, with room to move.
dxClusterGrid dxFitGrid(const dxClusterScene &scene, int cells);

// Returns the share of the dynamic inhabitants that are outside the grid.
double dxShareOutside(const dxClusterScene &scene);

// Returns whether that share is so large that the grid should be placed anew.
bool dxGridIsOutgrown(const dxClusterScene &scene);
