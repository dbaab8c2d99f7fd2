// The problem of each island of a world, as the exact step hands it to its solver.
#pragma once

#include <ode/ode.h>

#include <functional>

#include "config.h"
#include "step.h"
#include "util.h"

#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStep.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "islands_of_step.h"

// Solves a problem: dxWorldStepSolver's function.
using IslandSolve = std::function<void(const dxIslandStep &step, const dxWorldStepProblem &problem)>;

// Steps each island by `solve`.
inline void solveIslands(dWorldID world, dReal stepSize, const IslandSolve &solve) {
    struct Solver final : dxWorldStepSolver {
        explicit Solver(const IslandSolve &solve) : m_solve(solve) {}
        bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override {
            m_solve(step, problem);
            return false;
        }
        const IslandSolve &m_solve;
    } solver(solve);
    forIslands(world, stepSize, &dxEstimateStepMemoryRequirements, [&](const dxIsland &island, dxWorldProcessMemArena *arena) {
        dxWorldStep({world, stepSize, island, arena}, solver);
    });
}
