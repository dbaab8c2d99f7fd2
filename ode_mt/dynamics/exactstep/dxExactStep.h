// dWorldStep's stages for one island (the picture is in docs/steppers.md).
//
// The sequence of every sum is upstream's (dxStepIsland in ode/src/step.cpp), so the bits are, too. No memory is taken from the
// arena beyond what upstream's stepper takes at the same time, since a user's allocator sees how large the arena is
// (dxEstimateStepMemoryRequirements).
#pragma once

#include "config.h"
#include "objects.h"
#include "util.h"

class dxExactSolver;

// Seam: upstream's dWorldStep hands this out in the place of dxStepIsland. The context is part of a dxIslandCall, whose team
// solves large problems together.
void dxExactStepIsland(const dxStepperProcessingCallContext *context);

// The same with another solver.
void dxStepExactly(const dxStepperProcessingCallContext &island, dxExactSolver &solver);
