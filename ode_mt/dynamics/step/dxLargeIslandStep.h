// The large-island strategy: the islands in upstream's order, as the serial one, and each large island by all workers
// together. See docs/step.md.
#pragma once

#include "dynamics/step/dxStepStrategy.h"

void dxRunLargeIslandStep(const dxStepCall &call, const dxStepPlan &plan);
