// The solver "fast" (docs/direct-solver.md): solves large problems in body space, without a matrix of rows by rows, and leaves the others
// to Dantzig's algorithm.
//
// Threading: islands may be solved by several threads at the same time. The workers of a large island share what is done in body space.
#pragma once

#include "dynamics/world_step/dxWorldStepSolver.h"

class dxFastSolver final : public dxWorldStepSolver {
public:
    // The step's arena is as large as dxEstimateDirectStepMemory says.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override;

    // Frees what is kept from island to island and is not in use (dCloseODE, unloading).
    static void release();
};
