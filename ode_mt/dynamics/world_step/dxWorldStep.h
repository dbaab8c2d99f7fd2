// dWorldStep's stages for one island (the picture is in docs/exact.md).
//
// The sequence of every sum is upstream's (dxStepIsland in ode/src/step.cpp), so the bits are, too. No memory is taken from the
// arena beyond what upstream's stepper takes at the same time, since a user's allocator sees how large the arena is
// (dxEstimateStepMemoryRequirements).
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

class dxWorldStepSolver;
struct dxWorldStepProblem;

// Steps the island, with upstream's bits if the solver has them. `inLanes`: bodies are gathered and moved some at a time, with the same bits;
// for islands of which dxAreBodiesForLanes holds.
void dxWorldStep(const dxIslandStep &step, dxWorldStepSolver &solver, bool inLanes = false);

// The stages before the solver, for problems that are solved elsewhere (docs/remote.md); dxApplyResults is the one after it.
void dxMakeWorldStepProblem(const dxIslandStep &step, dxWorldStepProblem &problem, bool inLanes = false);
