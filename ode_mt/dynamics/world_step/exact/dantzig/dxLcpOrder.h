// The order in which Dantzig's algorithm takes the rows of a problem: rows without limits first, rows whose limits
// depend on others last, the rest as upstream's swaps leave them.
#pragma once

#include "dynamics/world_step/exact/dantzig/dxDantzigProblem.h"

// Writes the problem's row for each row of the solver's, and returns how many rows without limits there are.
unsigned dxFindLcpOrder(const dxDantzigProblem &problem, unsigned *order);
