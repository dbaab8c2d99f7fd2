// Dantzig's algorithm (ode_mt/dynamics/world_step/exact/dantzig), with upstream's bits. Large problems are solved by the workers of the step's
// island, if it has any.
#pragma once

#include <ode/common.h>

#include "dynamics/world_step/dxWorldStepSolver.h"

class dxDantzigSolver final : public dxWorldStepSolver {
public:
    // Makes the matrix in the step's arena, and solves.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override;

    // Solves with the matrix, made (dxMakeMatrix).
    static void solve(const dxIslandStep &step, const dxWorldStepProblem &problem, dReal *matrix);
};
