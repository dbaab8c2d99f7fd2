// The cells in which upstream's hash space stores a box, and the cell in which it finds a pair: dxHashSpace::collide in
// collision_space.cpp, derived in docs/collision-order.md.
#pragma once

#include <algorithm>

#include <ode/common.h>

struct dxHashLevels {
    int lowest, highest;  // dHashSpaceSetLevels
};

class dxHashCells {
public:
    enum class Kind { inTable, big, outOfRange };

    dxHashCells() = default;
    dxHashCells(const dReal aabb[6], const dxHashLevels &levels);

    // outOfRange: the box has cells whose numbers do not fit an int; upstream ends the program there.
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

private:
    static bool beginsBelowZero(int level, int x, int y, int z);
    // Upstream halves as often as there are levels between; after 31 times all bits are the sign.
    int shiftTo(int level) const { return std::min(level - m_level, 31); }

    Kind m_kind = Kind::big;
    int m_level = 0;
    int m_bounds[6] = {};  // as dxAABB::dbounds
};
