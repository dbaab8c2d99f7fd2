// Groups the islands of a step into blocks for workers: by estimated cost, largest first (longest processing time first
// keeps the end of the step short); small islands are combined until a block is large enough. The blocks do not depend
// on the workers, and no result depends on the blocks. Source of the rule: Graham, "Bounds on multiprocessing timing anomalies", 1969.
#pragma once

#include "dynamics/step/dxStepRecords.h"

// Fills records.order and records.blocks with the islands before `end`. `least`: the cost below which
// islands share a block.
void dxCutIslandBlocks(dxStepRecords &records, unsigned end, double least);
