// Forward solves for a panel of right-hand sides, one a lane: the kernel of dxForwardSolves.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "dynamics/world_step/kernels/dxTriangle.h"

class dxTaskRunner;

// A right-hand side is a column of a symmetric matrix: its element for row r is rightHandSides[index[r] * rightHandSkip
// + lane]. There are as many lanes as a cache line has elements, all aligned to cache lines.
struct dxSolvePanelTask {
    const dReal *const *L;  // as in dxSolveL1.h, row i at L[i]
    const dReal *rightHandSides;
    std::size_t rightHandSkip;
    const unsigned *index;
    dxSkyline skyline;
    unsigned zeros;       // rows of the solutions that are 0, and neither read nor written
    unsigned begin, end;  // rows to be solved for, multiples of four; those before them are solved
    dReal *solutions;     // by row, then by lane
};

// Each lane gets the bits of dxSolveL1Straight for a right-hand side of its own, `end` rows or more. Skipping by the
// skyline and the zeros is exact under the conditions named there. `runner`: its workers take kSharedRows rows at a
// time; null for the calling thread alone.
void dxSolvePanel(const dxSolvePanelTask &task, dxTaskRunner *runner = nullptr);

constexpr unsigned kSharedRows = 32;
