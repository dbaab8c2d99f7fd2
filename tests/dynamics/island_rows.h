// The rows of each island of a world, as the steppers' first stages leave them.
#pragma once

#include <ode/ode.h>

#include <functional>

#include "config.h"
#include "step.h"
#include "util.h"

#include "dynamics/exactstep/dxExactBodies.h"
#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/exactstep/dxExactResults.h"
#include "dynamics/exactstep/dxExactRows.h"
#include "dynamics/exactstep/dxJointOrder.h"
#include "dynamics/islands/dxIslandStep.h"
#include "islands_of_step.h"

// Calls `solve` for each island that has rows, with c/h and cfm/h in the places of b and x, and moves the bodies by what it leaves in the
// place of x. `solve` makes the links (dxMakeMatrix).
using IslandSolve = std::function<void(const dxIslandStep &step, dxExactProblem &problem)>;

inline void solveIslands(dWorldID world, dReal stepSize, const IslandSolve &solve) {
    forIslands(world, stepSize, &dxEstimateStepMemoryRequirements, [&](const dxIsland &island, dxWorldProcessMemArena *arena) {
        const dxIslandStep step{world, stepSize, island, arena};
        dxExactProblem problem;
        dxGatherBodies(step, problem);
        dxOrderJoints(step, problem);
        if (problem.rowCount > 0) {
            dxReadRows(step, problem);
            solve(step, problem);
        }
        dxApplyResults(step, problem);
    });
}
