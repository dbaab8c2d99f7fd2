// The memory of a run of Dantzig's algorithm (dxDantzigRun), beside the order of its rows and the factor.
#pragma once

#include <cstddef>

#include "dynamics/world_step/exact/dantzig/dxForwardSolves.h"
#include "dynamics/world_step/exact/dantzig/dxLcpArrays.h"
#include "dynamics/world_step/kernels/dxPivotLanes.h"

struct dxDantzigArrays {
    // For n rows, of which the first `unbounded` have no limits.
    static dxDantzigArrays take(dxWorldProcessMemArena *arena, unsigned n, unsigned unbounded);

    // The most that `take` needs, in bytes.
    static std::size_t memory(unsigned n);

    dReal *matrix;                  // of dxLcpMatrix
    unsigned *sets;                 // of dxIndexSets
    dReal **factorRows;             // L, by row
    dReal *diagonal;                // 1/D
    unsigned *begins;               // of the rows of L
    dReal *solutions;               // of dxForwardSolves
    unsigned *solutionWords;

    // By row, in the run's order.
    dReal *b, *x, *w, *deltaW;
    dxLimitPair *limits;
    dReal *side;           // for rows of N: the sign that w may have, 0 where the limits leave no room for x
    unsigned *leaving;     // positions in N of the rows that leave their side: a list of findDeltaW

    unsigned *halfBlockN;  // rows of N in each half of a block of lanes; 0
    dReal *deltaX;         // by position in C

    // In the order of the factorisation, for the column i that was asked for last.
    dReal *solved;     // L^-1 A(C,i)
    dReal *temporary;  // from findFactorColumn to findDeltaX: D^-1 L^-1 A(C,i)

private:
    dxDantzigArrays(dxArrayTaker &taker, unsigned n, unsigned unbounded);
};
