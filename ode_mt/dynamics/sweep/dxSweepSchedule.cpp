// Level scheduling of a triangular dependency graph (Saltz, "Aggregation methods for solving sparse triangular
// systems on multiprocessors", 1990): the level of a row is the length of the longest chain of rows that
// must come before it. Rows of one level share no body, so their order is free.
#include <algorithm>
#include <cstddef>

#include "dynamics/sweep/dxSweep.h"

namespace {

// The levels of all rows, in `order`; returns their number. `levelAfter`, by body: the first level at which it
// is free.
unsigned findLevels(const dxSweepIsland &island, const int *order, unsigned *level, unsigned *levelAfter) {
    std::fill_n(levelAfter, island.bodies, 0u);
    unsigned levels = 0;
    for (unsigned i = 0; i < island.rows; ++i) {
        const int *body = island.bodiesOfRow + 2 * static_cast<std::size_t>(order[i]);
        unsigned free = levelAfter[body[0]];
        if (body[1] != dxSweepIsland::kNone) {
            free = std::max(free, levelAfter[body[1]]);
            levelAfter[body[1]] = free + 1;
        }
        levelAfter[body[0]] = free + 1;
        level[i] = free;
        levels = std::max(levels, free + 1);
    }
    return levels;
}

// Counting sort, stable.
void sortByLevel(unsigned rows, const int *order, const unsigned *level, unsigned levels, unsigned *begin,
                 int *sorted) {
    std::fill_n(begin, levels, 0u);
    for (unsigned i = 0; i < rows; ++i) ++begin[level[i]];
    unsigned sum = 0;
    for (unsigned l = 0; l < levels; ++l) {
        const unsigned count = begin[l];
        begin[l] = sum;
        sum += count;
    }
    for (unsigned i = 0; i < rows; ++i) sorted[begin[level[i]]++] = order[i];
}

}  // namespace

void dxScheduleSweep(const dxSweepIsland &island, const int *order, const dxSweepSchedule &schedule) {
    const unsigned levels = findLevels(island, order, schedule.level, schedule.work);
    sortByLevel(island.rows, order, schedule.level, levels, schedule.work, schedule.order);
}
