// Dantzig's algorithm (dxDantzig.h), with upstream's bits. Large problems are solved by the workers of the step's
// island, if it has any.
#pragma once

#include <ode/common.h>

#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStep.h"

struct dxConstraintJoint;

class dxDantzigSolver final : public dxWorldStepSolver {
public:
    // Makes the matrix in the step's arena, and solves.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override;

    // Solves with the matrix, made (dxMakeMatrix).
    static void solve(const dxIslandStep &step, const dxWorldStepProblem &problem, dReal *matrix);
};

// --- what it solves: A = J inv(M) J' + cfm/h and b = c/h - J (v/h + inv(M) f) ----------------------------------

// Requires rows, read. Returns A, in the step's arena: its lower triangle, rows dPAD(rowCount) elements apart. Writes b into
// problem.pairsBX.
dReal *dxMakeMatrix(const dxIslandStep &step, const dxWorldStepProblem &problem);

// What the matrix is made of beside the rows. Motions: v/h + inv(M) f, six numbers a body; puts inverse masses beside the inverse tensors. Joints: by
// numbers of bodies.
void dxFindMotions(const dxWorldStepProblem &problem, dReal stepSize, dReal *motions);
void dxListConstraintJoints(const dxWorldStepProblem &problem, dxConstraintJoint *list);
