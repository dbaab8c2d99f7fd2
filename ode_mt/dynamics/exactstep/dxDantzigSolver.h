// Dantzig's algorithm (ode_mt/dynamics/exactstep/dantzig), with upstream's bits. Large problems are solved by the workers of the step's
// island, if it has any.
#pragma once

#include <ode/common.h>

#include "dynamics/exactstep/dxExactSolver.h"

class dxDantzigSolver final : public dxExactSolver {
public:
    // Makes the matrix in the step's arena, and solves.
    bool solve(const dxIslandStep &step, const dxExactProblem &problem) override;

    // Solves with the matrix, made (dxMakeMatrix).
    static void solve(const dxIslandStep &step, const dxExactProblem &problem, dReal *matrix);
};
