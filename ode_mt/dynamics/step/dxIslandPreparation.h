// What an island-parallel step finds out before it shares its islands out: which of them call the user, how many random
// numbers they draw, which joint feedback they have in common, and the blocks that workers take.
#pragma once

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/dxStepRecords.h"

// Fills the records but for the random numbers, on workers. Changes nothing of the world's. Throws std::bad_alloc.
void dxPrepareIslands(const dxStepCall &call, unsigned workers, dxStepRecords &records);

// Takes the random numbers of all islands that are shared out from the process's sequence, as one block.
void dxReserveRandomNumbers(const dxStepCall &call, dxStepRecords &records);
