// Which of many worlds may be stepped at the same time (dxStepWorlds): runs of neighbours, in the order of the worlds.
//
// The calling thread alone steps a world, after all before it, if code of the user's runs in its step (a moved-callback, memory functions, a
// threading implementation), if it has a number of threads of its own, or if it takes so much of the time that its islands should run on several
// workers. The same holds for all worlds if the user has a handler of errors or messages, which may look at any of them, or an allocator.
//
// Threading: the thread that makes the call.
#pragma once

#include <vector>

#include "dynamics/step/dxCostModel.h"
#include "dynamics/step/dxStepWorlds.h"

struct dxWorldRun {
    unsigned begin, end;
    bool isShared;  // else it goes in order
};

// Costs of all worlds and of the largest one. Units: ns on a machine of scale 1.
struct dxWorldCosts {
    double total = 0, largest = 0;
};

namespace dxWorldRuns {

// Returns the number of threads that the settings and the machine allow.
unsigned workerLimit();

// Estimates costs as for worlds of small islands, in which a joint costs the same in either stepper.
dxWorldCosts costs(dxWorld *const *worlds, unsigned count);

// Throws std::bad_alloc.
std::vector<dxWorldRun> cut(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, unsigned workers);

}  // namespace dxWorldRuns
