// dWorldQuickStep for one island: the stages in their order. docs/exact.md has the picture.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

// Steps the island. On the thread that the island has been given to; a large island's workers take part. The bits are those of
// upstream's dxQuickStepIsland on one thread, for any number of workers.
void dxQuickStep(const dxIslandStep &step);
