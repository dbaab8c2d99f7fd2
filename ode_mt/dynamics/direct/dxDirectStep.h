// dWorldStep's stages for one island of a world whose solver is "fast" (docs/direct-solver.md).
//
// Rows, right-hand sides and results are those of the exact step; large problems are solved in body space instead of by Dantzig's
// algorithm, and no matrix of rows by rows is made.
#pragma once

#include "dynamics/islands/dxIslandStep.h"

// Steps the island. Its arena is as large as dxEstimateDirectStepMemory says.
void dxDirectStep(const dxIslandStep &step);

// Frees the solvers that are not in use (dCloseODE, unloading).
void dxReleaseDirectSolvers();
