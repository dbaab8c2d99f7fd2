// How much memory the direct step takes from a step's arena.
#pragma once

#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

// Islands that have both fewer rows with limits and fewer rows in all may be solved by Dantzig's algorithm, with or without their rows
// without limits: it is faster there (docs/direct-solver.md has the figures).
constexpr unsigned kMinDirectLimitedRows = 110, kMinDirectRows = 700;

// In place of upstream's dxEstimateStepMemoryRequirements, and never more than that: there is no matrix of kMinDirectRows rows
// or more.
sizeint dxEstimateDirectStepMemory(dxBody *const *bodies, unsigned bodyCount, dxJoint *const *joints, unsigned jointCount);
