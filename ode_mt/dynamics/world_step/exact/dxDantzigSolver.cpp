#include "dynamics/world_step/exact/dxDantzigSolver.h"

#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/exact/dantzig/dxDantzig.h"
#include "dynamics/world_step/exact/dantzig/dxUpstreamLcp.h"
#include "dynamics/world_step/exact/dxExactMatrix.h"

static_assert(int(dxJoint::GI2_RHS) == int(PBX_B) && int(dxJoint::GI2_CFM) == int(PBX_X) &&
                  int(dxJoint::GI2__RHS_CFM_MAX) == int(PBX__MAX),
              "joints write b where the solver reads it");
static_assert(int(dxJoint::GI2_LO) == int(PLH_LO) && int(dxJoint::GI2_HI) == int(PLH_HI) &&
                  int(dxJoint::GI2__LO_HI_MAX) == int(PLH__MAX),
              "joints write limits where the solver reads them");

bool dxDantzigSolver::solve(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    void *const state = step.arena->SaveState();
    solve(step, problem, dxMakeMatrix(step, problem));
    step.arena->RestoreState(state);
    return false;
}

// Upstream tells its solver of as many rows without limits as there are joints of such rows; the solver finds the others by
// their limits, and the order in which it looks at rows depends on that.
void dxDantzigSolver::solve(const dxIslandStep &step, const dxWorldStepProblem &problem, dReal *matrix) {
    dxSolveDantzig(step.islandWorkers, step.arena, problem.rowCount, matrix, problem.pairsBX, nullptr, problem.unboundedJoints,
                   problem.pairsLoHi, problem.normalOf);
}
