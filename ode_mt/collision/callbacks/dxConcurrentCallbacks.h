// dSpaceCollide with the near-callbacks of independent pairs on several threads, for callers who have said that
// theirs may run so (dODE_MT_SetCallbackPolicy).
//
// Pairs are found as in serial calls; tasks that share no body (dxPairTasks) are run by workers, each task's pairs in
// order; contact joints are put into their lists afterwards, pair by pair in upstream's order (dxContactLog). So the
// world is the one that upstream leaves, as long as callbacks do what docs/callbacks.md asks of them.
#pragma once

#include <ode/ode.h>

class dxOrderedSpace;
class dxTaskRunner;

// The space is not locked and has two geoms at least. Returns false, before any callback, if it is not possible.
bool dxCollideConcurrently(dxOrderedSpace &space, dxTaskRunner &runner, void *data, dNearCallback *callback);
