// How much memory the direct step takes from a step's arena.
#pragma once

#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

// Islands of so many rows or more are never solved by Dantzig's algorithm alone, which is slower there (docs/direct-solver.md).
constexpr unsigned kMinDirectRows = 700;

// In place of upstream's dxEstimateStepMemoryRequirements, and no more than that and a trial of Dantzig's algorithm (dxDantzigTrial.h) need: there
// is no matrix of kMinDirectRows rows or more.
sizeint dxEstimateDirectStepMemory(dxBody *const *bodies, unsigned bodyCount, dxJoint *const *joints, unsigned jointCount);
