// dWorldQuickStep's stages for a group of islands of a world whose solver is "fast" (docs/fast.md).
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

// Steps the group. Its arena is as large as upstream's estimate says. The workers of a large group share its stages.
void dxFastQuickStep(const dxIslandStep &step);
