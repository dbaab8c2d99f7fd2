// What one step knows about its islands and workers while it is in progress. Records are reused from step to step, so
// that a steady state allocates nothing.
//
// Threading: the survey and the step of an island write that island's record, a worker writes its
// own worker record, the caller writes everything else. No two threads write one record.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/dxCacheLine.h"
#include "dynamics/step/dxDeferredRun.h"
#include "dynamics/step/islands/dxIsland.h"
#include "dynamics/step/islands/dxUndoLog.h"

struct dxIslandRecord {
    dxIsland island;
    double cost;         // dxCostModel, scale 1
    unsigned rows;       // of the constraint system; 0 unless random numbers depend on it
    bool inOrder;        // must be stepped on the calling thread, after all islands before it
    bool stepped;
    bool isRemote;    // remote workers solve it (dxRemoteStep)
    unsigned worker;  // that stepped it, or made its problem
    dxUndoLog::Mark undoBegin, undoEnd;
};

struct alignas(kCacheLine) dxWorkerRecord {
    dxWorldProcessMemArena *arena = nullptr;
    dxUndoLog undo;
    unsigned islands = 0;  // stepped

    void reset();  // keeps the memory
};

// Consecutive entries of dxStepRecords::order that one worker takes at once.
struct dxIslandBlock {
    unsigned begin, end;
};

struct dxStepRecords {
    std::vector<dxIslandRecord> islands;
    std::vector<unsigned> order;  // of islands, as workers get them
    std::vector<dxIslandBlock> blocks;
    std::vector<dxWorkerRecord> workers;
    dxDeferredRun run;         // whose units are the islands
    unsigned inOrderFrom = 0;  // first island that has to be stepped in order

    // Gives the records back to a pool of the process.
    struct Return {
        void operator()(dxStepRecords *records) const;
    };
    using Lease = std::unique_ptr<dxStepRecords, Return>;

    // Returns records that no step in progress uses.
    static Lease take();
};
