// Workers of the threading implementation that the user gave a world with
// dWorldSetStepThreadingImplementation. They step that world's islands instead of the process's own
// workers, and change no bits.
//
// A manager belongs to an implementation, which several worlds may share (dxLentThreads).
#pragma once

#include <ode/ode.h>

#include "threading/dxThreadManager.h"

namespace dxWorldWorkers {

// Whether the user gave the world an implementation.
bool given(const dxWorld *world);

// Whether functions of the user's own, or the user's limit for the world, have a single thread run all calls of a step.
// They are then asked for all that upstream asks of them, in upstream's order: they may count calls, refuse them, or
// throw. Calls of upstream's own functions are not observable, and a pool that no thread serves yet would block the
// step.
bool haveToBeAsked(const dxWorld *world);

// How many workers it lends.
unsigned count(const dxWorld *world);

// To be called before a step. False if the implementation given refuses its resources: no step then, as
// upstream.
bool prepare(const dxWorld *world);

void run(const dxWorld *world, unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context);

// The user has just given the world an implementation.
void lend(const dxWorld *world);

// Gives the workers of the world's implementation back: it is about to be exchanged or freed. Other
// worlds that use it borrow them anew.
void giveBack(const dxWorld *world);

}  // namespace dxWorldWorkers
