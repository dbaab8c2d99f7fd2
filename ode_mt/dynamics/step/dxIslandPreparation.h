// What an island-parallel step finds out before its islands run on workers: which of them call the user, how many random
// numbers they draw, which joint feedback they have in common, and the blocks that workers take.
//
// Blocks are ordered by estimated cost, largest first (longest processing time first keeps the end of the step short); small islands are combined
// until a block is large enough. The blocks do not depend on the workers, and no result depends on the blocks. Source of the rule: Graham, "Bounds on
// multiprocessing timing anomalies", 1969.
//
// Threading: the thread that calls the step.
#pragma once

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/dxStepRecords.h"

// Fills the records except the random numbers, on workers. The world is unchanged. Throws std::bad_alloc.
void dxPrepareIslands(const dxStepCall &call, unsigned workers, dxStepRecords &records);

// Takes the random numbers of all islands that run on workers from the process's sequence, as one block.
void dxReserveRandomNumbers(const dxStepCall &call, dxStepRecords &records);

// Fills records.order and records.blocks with the islands before `end`. `minCost`: below it islands share a block.
void dxCutIslandBlocks(dxStepRecords &records, unsigned end, double minCost);
