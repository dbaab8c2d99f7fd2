// The orders in which an island's rows are swept: that of the joints, a schedule with the same results, and shuffles of the former.
//
// Source of the schedule: Saltz, "Aggregation methods for solving sparse triangular systems on multiprocessors", 1990 (level scheduling of a
// triangular dependency graph): the level of a row is the length of the longest chain of rows that must come before it. Rows of one level share no
// body, so their order is free.
#pragma once

#include "dynamics/step/islands/dxIslandProblem.h"

// Calls visit(row) for the rows without a friction index, then for the others, whose bounds follow from those; each in the order of their
// joints. That is upstream's order before the first shuffle.
template <class Visit>
void dxForRowsInOrder(const dxIslandProblem &problem, const Visit &visit) {
    unsigned withFrictionIndex = 0;
    for (unsigned row = 0; row < problem.rowCount; ++row)
        if (problem.rows[row].hasFrictionIndex())
            ++withFrictionIndex;
        else
            visit(row);
    for (unsigned row = 0; withFrictionIndex != 0; ++row) {
        if (!problem.rows[row].hasFrictionIndex()) continue;
        visit(row);
        --withFrictionIndex;
    }
}

// Sets `order` to that order.
inline void dxOrderRows(const dxIslandProblem &problem) {
    int *end = problem.order;
    dxForRowsInOrder(problem, [&end](unsigned row) { *end++ = static_cast<int>(row); });
}

// Writes another order to problem.order, with the same results, in which neighbours seldom wait for one another.
void dxScheduleSor(const dxIslandProblem &problem);

// Sweeps between two shuffles; upstream shuffles before every eighth sweep but the first.
constexpr unsigned kShuffleInterval = 8;

// Swaps every entry but the first with a random one before it or itself, in ascending order. Draws rows - 1 numbers as
// one block: from the island's own part of the random sequence, or from the shared one.
void dxShuffleRows(int *order, unsigned rows);
