// Upstream's order of rows before the first shuffle.
#pragma once

#include "dynamics/step/islands/dxIslandProblem.h"

// Calls visit(row) for the rows that no other row bounds, then for the others, whose bounds follow from those; each in the order of
// their joints.
template <class Visit>
void dxForRowsInOrder(const dxIslandProblem &problem, const Visit &visit) {
    unsigned bounded = 0;
    for (unsigned row = 0; row < problem.rowCount; ++row)
        if (problem.rows[row].isBounded())
            ++bounded;
        else
            visit(row);
    for (unsigned row = 0; bounded != 0; ++row) {
        if (!problem.rows[row].isBounded()) continue;
        visit(row);
        --bounded;
    }
}

// Sets `order` to that order.
inline void dxOrderRows(const dxIslandProblem &problem) {
    int *end = problem.order;
    dxForRowsInOrder(problem, [&end](unsigned row) { *end++ = static_cast<int>(row); });
}
