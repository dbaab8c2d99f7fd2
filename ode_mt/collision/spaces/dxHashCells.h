// The cells in which upstream's hash space stores a box, and the cell in which it finds a pair: dxHashSpace::collide in
// collision_space.cpp, derived in docs/collision.md.
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

    // none: of no box. outOfRange: the box has cells whose numbers do not fit an int; upstream ends the program there.
    Kind kind() const { return m_kind; }
    int level() const { return m_level; }

    struct Cell {
        int x, y, z;
        // Upstream finds a cell by a number that differs for columns that begin below zero: such a cell is found from
        // such columns alone.
        bool isOfColumnBelowZero = false;

        bool operator==(const Cell &other) const {
            return x == other.x && y == other.y && z == other.z && isOfColumnBelowZero == other.isOfColumnBelowZero;
        }
    };

    // Visits the cells that the box covers on a level, its own or one above, in upstream's order. Requires kind() ==
    // inTable.
    template <class Visit>
    void forEachCell(int level, const Visit &visit) const {
        const int shift = shiftTo(level), lowZ = m_bounds[4] >> shift;
        for (int x = m_bounds[0] >> shift; x <= m_bounds[1] >> shift; ++x)
            for (int y = m_bounds[2] >> shift; y <= m_bounds[3] >> shift; ++y) {
                const bool isBelow = beginsBelowZero(level, x, y, lowZ);
                for (int z = lowZ; z <= m_bounds[5] >> shift; ++z) visit(Cell{x, y, z, isBelow});
            }
    }

    // Finds the first cell, in upstream's order, in which a search for `searcher`, on the level of `found`, finds
    // `found`. Returns false if upstream does not find this pair. Requires both in the table and searcher.level() <=
    // found.level().
    static bool firstSharedCell(const dxHashCells &searcher, const dxHashCells &found, Cell &cell);
    // The same by the place of the cell among those that `searcher` covers, at most two along an axis: 4 for the upper one of x, plus 2
    // for the upper one of y, plus 1 for the upper one of z. Upstream examines them in the order of these numbers.
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
        // Columns that begin at the same cell, or not below zero, begin on the same side of it.
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
    // Upstream halves as often as there are levels between; after 31 times all bits are the sign.
    int shiftTo(int level) const { return std::min(level - m_level, 31); }

    Kind m_kind = Kind::none;
    int m_level = 0;
    int m_bounds[6] = {};  // as dxAABB::dbounds
};
