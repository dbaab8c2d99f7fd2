// How much memory the direct step takes from a step's arena.
#pragma once

#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

// Islands of fewer rows are solved by Dantzig's algorithm, which is faster there (docs/direct-solver.md has the figures).
constexpr unsigned kMinDirectRows = 120;

// In place of upstream's dxEstimateStepMemoryRequirements, and never more than that: there is no matrix of more than
// kMinDirectRows rows.
sizeint dxEstimateDirectStepMemory(dxBody *const *bodies, unsigned bodyCount, dxJoint *const *joints, unsigned jointCount);
