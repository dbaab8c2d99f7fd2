// Where upstream's hash space puts a box, and in which cell it finds a pair: dxHashSpace::collide in
// collision_space.cpp, derived in docs/collision-order.md.
#pragma once

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
    };

    // The first cell, in upstream's order, in which a search for `searcher`, on the level of `found`, meets
    // `found`. False: upstream does not see this pair. Needs both in the table, searcher.level() <=
    // found.level().
    static bool firstSharedCell(const dxHashCells &searcher, const dxHashCells &found, Cell &cell);

private:
    Kind m_kind = Kind::big;
    int m_level = 0;
    int m_bounds[6] = {};  // as dxAABB::dbounds
};
