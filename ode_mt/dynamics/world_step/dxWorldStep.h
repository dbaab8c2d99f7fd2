// dWorldStep's stages for one island (the picture is in docs/exact.md).
//
// The sequence of every sum is upstream's (dxStepIsland in ode/src/step.cpp), so the bits are, too. No memory is taken from the
// arena beyond what upstream's stepper takes at the same time, since a user's allocator sees how large the arena is
// (dxEstimateStepMemoryRequirements).
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// What solves an island's problem: finds x, the forces of its rows.
class dxWorldStepSolver {
public:
    // Requires rows, read. Writes x into problem.pairsBX; b and the limits of friction rows may be written over. What is taken of
    // the step's arena is given back. Returns whether J' x has been added to the bodies' accumulators, too, which is left to
    // dxApplyResults otherwise, as it always is where a joint has feedback.
    virtual bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) = 0;

protected:
    ~dxWorldStepSolver() = default;
};

// Steps the island, with upstream's bits if the solver has them. `inLanes`: bodies are gathered and moved some at a time, with the same bits;
// for islands of which dxAreBodiesForLanes holds.
void dxWorldStep(const dxIslandStep &step, dxWorldStepSolver &solver, bool inLanes = false);

// The stages before the solver, for problems that are solved elsewhere (docs/remote.md); dxApplyResults is the one after it.
void dxMakeWorldStepProblem(const dxIslandStep &step, dxWorldStepProblem &problem, bool inLanes = false);
