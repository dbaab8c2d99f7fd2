// The fast dWorldStep (docs/fast.md): each island is solved by the method that is the cheapest for it: in body space, without a matrix
// of rows by rows; with its bilateral rows eliminated; or by Dantzig's algorithm.
//
// Threading: islands may be solved by several threads at the same time. The workers of a large island share what is done in body space.
#pragma once

#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

#include "dynamics/world_step/dxWorldStep.h"

class dxFastWorldStep final : public dxWorldStepSolver {
public:
    // Requires a step's arena as large as dxEstimateFastWorldStepMemory says.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override;
};

// Returns how much memory a step takes from its arena, in place of upstream's dxEstimateStepMemoryRequirements: no more than that and a trial
// of Dantzig's algorithm (dxDantzigTrial.h) need. There is no matrix of kDantzigThreshold rows or more.
sizeint dxEstimateFastWorldStepMemory(dxBody *const *bodies, unsigned bodyCount, dxJoint *const *joints, unsigned jointCount);
