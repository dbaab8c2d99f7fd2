// Workers of the threading implementation that the user gave a world with
// dWorldSetStepThreadingImplementation. They step that world's islands instead of the process's own
// workers, and change no bits.
//
// A manager belongs to an implementation, which several worlds may share, so the managers are kept beside
// the worlds; a step looks its own up in a list that is as short as there are implementations.
#pragma once

#include "dynamics/dxIsland.h"
#include "threading/dxThreadManager.h"

namespace dxWorldWorkers {

// How many workers the world's implementation lends; 0: none was given, or it has no threads to lend.
unsigned count(const dxWorld *world);

void run(const dxWorld *world, unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context);

// Gives the workers of the world's implementation back: it is about to be exchanged or freed. Other
// worlds that use it borrow them anew.
void giveBack(const dxWorld *world);

}  // namespace dxWorldWorkers
