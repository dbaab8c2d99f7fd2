// The cells in which upstream's hash space stores a box, and the cell in which it finds a pair.
//
// Source: dxHashSpace::collide in upstream's collision_space.cpp; docs/collision.md derives what is computed here.
// Threading: none, pure functions.
#pragma once

#include <algorithm>

#include <ode/common.h>

struct dxHashLevels {
    int lowest, highest;  // dHashSpaceSetLevels
};

class dxHashCells {
public:
    enum class Kind { none, inTable, big, outOfRange };

    dxHashCells() = default;
    dxHashCells(const dReal aabb[6], const dxHashLevels &levels);

    // none: there is no box. outOfRange: the numbers of the box's cells do not fit an int; upstream's assertion fails there.
    Kind kind() const { return m_kind; }
    int level() const { return m_level; }

    struct Cell {
        int x, y, z;
        // Upstream numbers the cells of a column differently if the column begins below zero. So a cell that was stored from such a column is
        // found from such columns alone.
        bool isOfColumnBelowZero = false;

        bool operator==(const Cell &other) const {
            return x == other.x && y == other.y && z == other.z && isOfColumnBelowZero == other.isOfColumnBelowZero;
        }
    };

    // Visits the cells that the box covers on its own level or on one above, in upstream's order. Requires kind() == inTable.
    template <class Visit>
    void forEachCell(int level, const Visit &visit) const {
        const int shift = shiftTo(level), lowZ = m_bounds[4] >> shift;
        for (int x = m_bounds[0] >> shift; x <= m_bounds[1] >> shift; ++x)
            for (int y = m_bounds[2] >> shift; y <= m_bounds[3] >> shift; ++y) {
                const bool isBelow = beginsBelowZero(level, x, y, lowZ);
                for (int z = lowZ; z <= m_bounds[5] >> shift; ++z) visit(Cell{x, y, z, isBelow});
            }
    }

    // Computes the first cell, in upstream's order, in which `searcher` finds `found` on the level of `found`. Returns false if upstream does not
    // find this pair. Requires that both are in the table and searcher.level() <= found.level().
    static bool firstSharedCell(const dxHashCells &searcher, const dxHashCells &found, Cell &cell);
    // Computes the same as the cell's number among those that `searcher` covers, at most two along an axis: 4 for the upper one of x, plus 2
    // for the upper one of y, plus 1 for the upper one of z. Upstream visits them in the order of these numbers.
    static bool firstSharedCorner(const dxHashCells &searcher, const dxHashCells &found, unsigned &corner) {
        const int shift = searcher.shiftTo(found.m_level);
        int low[3];
        bool isShared = true;
        unsigned place = 0;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = searcher.m_bounds[2 * axis] >> shift;
            const int foundLow = found.m_bounds[2 * axis];
            const int high = std::min(searcher.m_bounds[2 * axis + 1] >> shift, found.m_bounds[2 * axis + 1]);
            isShared = isShared && std::max(low[axis], foundLow) <= high;
            place = 2 * place + (foundLow > low[axis]);
        }
        corner = place;
        // Columns that begin at the same cell, or both at zero or above, begin on the same side of zero.
        const int foundLowZ = found.m_bounds[4];
        if (!isShared || low[2] == foundLowZ || (low[2] >= 0 && foundLowZ >= 0)) return isShared;
        Cell cell;
        if (!firstSharedCell(searcher, found, cell)) return false;
        corner = 4 * static_cast<unsigned>(cell.x != low[0]) + 2 * static_cast<unsigned>(cell.y != low[1]) +
                 static_cast<unsigned>(cell.z != low[2]);
        return true;
    }

private:
    static bool beginsBelowZero(int level, int x, int y, int z);
    // Returns how often upstream halves a cell's number to get to a level; after 31 times all bits are the sign.
    int shiftTo(int level) const { return std::min(level - m_level, 31); }

    Kind m_kind = Kind::none;
    int m_level = 0;
    int m_bounds[6] = {};  // upstream's dxAABB::dbounds
};
