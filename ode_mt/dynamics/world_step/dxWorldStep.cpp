#include "dynamics/world_step/dxWorldStep.h"

#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/world_step/dxWorldStepRows.h"
#include "dynamics/world_step/dxWorldStepBodies.h"
#include "dynamics/world_step/dxWorldStepProblem.h"

// All stages but the solver are serial. Each reads what those before it have written.
void dxWorldStep(const dxIslandStep &step, dxWorldStepSolver &solver, bool inLanes) {
    dxWorldStepProblem problem;
    dxMakeWorldStepProblem(step, problem, inLanes);

    bool areForcesApplied = false;
    if (problem.rowCount > 0) {
        // Reads velocities, accumulators, inertia, rows, limits. Writes x. Dantzig's algorithm is parallel for large problems, if the
        // island has workers.
        const dxSolverSpan span(problem.rowCount);
        areForcesApplied = solver.solve(step, problem);
    }

    // Reads x, rows, inertia, accumulators. Writes feedback, velocities and poses, clears accumulators; tells spaces and the
    // user of each body that has moved before it goes on to the next one.
    dxApplyResults(step, problem, areForcesApplied, inLanes);
}

void dxMakeWorldStepProblem(const dxIslandStep &step, dxWorldStepProblem &problem, bool inLanes) {
    // Reads bodies and gravity. Writes tags and inertia, adds gravity and gyroscopic torque to the bodies' accumulators.
    dxGatherBodies(step, problem, inLanes);

    // Asks joints how many rows they have (getInfo1). Writes the list of joints, and how many rows there are.
    dxOrderJoints(step, problem);

    // Asks joints for their rows (getInfo2), which may add to accumulators. Writes the Jacobian, c, cfm, limits, and the links from
    // bodies to joints.
    if (problem.rowCount > 0) dxReadRows(step, problem);
}
