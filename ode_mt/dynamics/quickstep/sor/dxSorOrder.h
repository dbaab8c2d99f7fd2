// Upstream's order of rows before the first shuffle.
#pragma once

#include "dynamics/islands/dxIslandProblem.h"

// Calls visit(row) for the rows that no other row bounds, then for the others, whose bounds follow from those; each in the order of
// their joints.
template <class Visit>
void dxForRowsInOrder(const dxIslandProblem &problem, const Visit &visit) {
    for (const bool bounded : {false, true})
        for (unsigned row = 0; row < problem.rowCount; ++row)
            if (problem.rows[row].isBounded() == bounded) visit(row);
}
