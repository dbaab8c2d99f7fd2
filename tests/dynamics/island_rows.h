// The problem of each island of a world, as the exact step hands it to its solver.
#pragma once

#include <ode/ode.h>

#include <functional>

#include "config.h"
#include "step.h"
#include "util.h"

#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/exactstep/dxExactSolver.h"
#include "dynamics/exactstep/dxExactStep.h"
#include "dynamics/islands/dxIslandStep.h"
#include "islands_of_step.h"

// Solves a problem: dxExactSolver's function.
using IslandSolve = std::function<void(const dxIslandStep &step, const dxExactProblem &problem)>;

// Steps each island by `solve`.
inline void solveIslands(dWorldID world, dReal stepSize, const IslandSolve &solve) {
    struct Solver final : dxExactSolver {
        explicit Solver(const IslandSolve &solve) : m_solve(solve) {}
        bool solve(const dxIslandStep &step, const dxExactProblem &problem) override {
            m_solve(step, problem);
            return false;
        }
        const IslandSolve &m_solve;
    } solver(solve);
    forIslands(world, stepSize, &dxEstimateStepMemoryRequirements, [&](const dxIsland &island, dxWorldProcessMemArena *arena) {
        dxExactStep({world, stepSize, island, arena}, solver);
    });
}
