#include "dynamics/quick_step/sor/dxSorOrder.h"

#include <algorithm>
#include <utility>

#include "dynamics/step/random/dxIslandDraws.h"
#include "dynamics/step/random/dxRandom.h"

namespace {

// Sets the rows' levels; returns the number of levels. A body's level is the first at which it is free.
unsigned findLevels(const dxIslandProblem &problem) {
    for (unsigned body = 0; body < problem.bodyCount; ++body) problem.accelerations[body].level = 0;
    unsigned levels = 0;
    dxForRowsInOrder(problem, [&](unsigned index) {
        dxConstraintRow &row = problem.rows[index];
        unsigned &level1 = problem.accelerations[row.body[0]].level;
        row.level = level1;
        if (row.hasSecondBody()) {
            unsigned &level2 = problem.accelerations[row.body[1]].level;
            row.level = std::max(level1, level2);
            level2 = row.level + 1;
        }
        level1 = row.level + 1;
        levels = std::max(levels, level1);
    });
    return levels;
}

// Counting sort, stable. Where a level begins is counted in the row of that index; there are no more levels than rows.
void sortByLevel(const dxIslandProblem &problem, unsigned levels) {
    dxConstraintRow *const rows = problem.rows;
    for (unsigned level = 0; level < levels; ++level) rows[level].levelBegin = 0;
    for (unsigned row = 0; row < problem.rowCount; ++row) ++rows[rows[row].level].levelBegin;
    unsigned sum = 0;
    for (unsigned level = 0; level < levels; ++level) sum += std::exchange(rows[level].levelBegin, sum);
    dxForRowsInOrder(problem, [&](unsigned row) { problem.order[rows[rows[row].level].levelBegin++] = static_cast<int>(row); });
}

}  // namespace

// In a chain nearly every row waits for another one, in any order. Where two rows in turn do not, a schedule pays.
void dxScheduleSor(const dxIslandProblem &problem) {
    const unsigned levels = findLevels(problem);
    if (8 * levels > 7 * problem.rowCount)
        dxOrderRows(problem);
    else
        sortByLevel(problem, levels);
}

void dxShuffleRows(int *order, unsigned rows) {
    if (rows < 2) return;
    std::uint32_t seed = dxTakeIslandDraws(rows - 1);
    for (unsigned i = 1; i < rows; ++i) {
        seed = dxRandom::next(seed);
        std::swap(order[i], order[dxRandom::toRange(seed, i + 1)]);
    }
}
