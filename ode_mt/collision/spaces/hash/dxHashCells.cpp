#include "collision/spaces/hash/dxHashCells.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>

#include "config.h"
#include "common.h"

namespace {

constexpr int kNoLevel = INT_MAX;

// Returns the lowest level whose cells are as large as the box, which then covers at most two cells along an axis.
int levelOf(const dReal aabb[6]) {
    for (int axis = 0; axis < 3; ++axis)
        if (aabb[2 * axis] <= -dInfinity || aabb[2 * axis + 1] >= dInfinity) return kNoLevel;
    dReal edge = aabb[1] - aabb[0];
    const dReal y = aabb[3] - aabb[2], z = aabb[5] - aabb[4];
    if (y > edge) edge = y;
    if (z > edge) edge = z;
    int level;
    std::frexp(edge, &level);
    return level;
}

}  // namespace

// Upstream numbers the slots of a column of cells (x, y fixed) upwards from its lowest cell. Where the sum 1000 level + 100 x + 10 y + z (level, x
// and y as unsigned numbers) is below zero at the lowest cell, the unsigned remainder jumps within the column. So the same cell has one slot for a
// box that begins below zero and another for one that does not.
bool dxHashCells::beginsBelowZero(int level, int x, int y, int z) {
    const std::uint64_t base = static_cast<unsigned>(level) * UINT64_C(1000) +
                               static_cast<unsigned>(x) * UINT64_C(100) +
                               static_cast<unsigned>(y) * UINT64_C(10);
    return z < 0 && base < static_cast<std::uint64_t>(-static_cast<std::int64_t>(z));
}

dxHashCells::dxHashCells(const dReal aabb[6], const dxHashLevels &levels) {
    m_level = std::max(levelOf(aabb), levels.lowest);
    m_kind = m_level <= levels.highest ? Kind::inTable : Kind::big;
    if (m_kind == Kind::big) return;
    const dReal cellsPerUnit = dRecip(std::ldexp(dReal(1), m_level));
    for (int i = 0; i < 6; ++i) {
        const dReal bound = aabb[i] * cellsPerUnit;
        if (!(bound >= dMinIntExact && bound < dMaxIntExact)) {
            m_kind = Kind::outOfRange;
            return;
        }
        const int truncated = static_cast<int>(bound);
        m_bounds[i] = truncated - (bound < static_cast<dReal>(truncated));  // rounded down
    }
}

bool dxHashCells::firstSharedCell(const dxHashCells &searcher, const dxHashCells &found, Cell &cell) {
    const int shift = searcher.shiftTo(found.m_level);
    int low[3], high[3], searcherLowZ = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int searcherLow = searcher.m_bounds[2 * axis] >> shift;
        const int searcherHigh = searcher.m_bounds[2 * axis + 1] >> shift;
        low[axis] = std::max(searcherLow, found.m_bounds[2 * axis]);
        high[axis] = std::min(searcherHigh, found.m_bounds[2 * axis + 1]);
        searcherLowZ = searcherLow;
    }
    if (low[2] > high[2]) return false;
    const int foundLowZ = found.m_bounds[4];
    for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
            if (beginsBelowZero(found.m_level, x, y, searcherLowZ) ==
                beginsBelowZero(found.m_level, x, y, foundLowZ)) {
                cell = {x, y, low[2], false};
                return true;
            }
    return false;
}
