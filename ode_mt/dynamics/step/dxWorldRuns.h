// Which of many worlds may be stepped at the same time (dxStepWorlds): runs of neighbours, in the order of the worlds.
//
// A world is stepped by the calling thread alone, when all before it have been, if code of the user's runs in its step (a
// moved-callback, memory functions, a threading implementation), if it has a number of threads of its own, or if it takes so much of the
// time that its islands have to be shared out. All worlds are if a handler of errors or messages, which may look at any of them, or an
// allocator is the user's.
#pragma once

#include <vector>

#include "dynamics/step/dxCostModel.h"
#include "dynamics/step/dxStepWorlds.h"

struct dxWorldRun {
    unsigned begin, end;
    bool isShared;  // else it goes in order
};

// ns on a machine of scale 1, of all worlds and of the one that takes longest.
struct dxWorldCosts {
    double total = 0, largest = 0;
};

namespace dxWorldRuns {

// Threads that the settings and the machine allow.
unsigned workerLimit();

// Worlds of small islands, in which a joint costs the same in either stepper.
dxWorldCosts costs(dxWorld *const *worlds, unsigned count);

// Throws std::bad_alloc.
std::vector<dxWorldRun> cut(dxWorld *const *worlds, unsigned count, const dxWorldStepper &stepper, unsigned workers);

}  // namespace dxWorldRuns
