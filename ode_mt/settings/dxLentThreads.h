// The managers of threads that the program lends (dxThreadManagerUser): one for each lender, for all that use it. Several worlds may share an
// implementation, and the process may have it too; two managers would have two calls waiting in its pool.
//
// In a forked child the threads do not exist: worlds and the process work alone there, until the child lends some itself.
//
// A run looks its manager up in a list of all lenders, which are few. Threading: any thread.
#pragma once

#include <memory>

#include <ode/ode.h>

#include "threading/managers/dxThreadManagerUser.h"

namespace dxLentThreads {

// The program lends these threads now.
void lend(const dxThreadLender &lender);

// Throws std::bad_alloc.
std::shared_ptr<dxThreadManagerUser> managerOf(const dxThreadLender &lender);

// Has the threads leave the library: waits for them, unless a run of another thread goes on, which then waits at its end. A later run with the lender
// makes a new manager.
void giveBack(const dxThreadLender &lender);

}  // namespace dxLentThreads

// Workers of the threading implementation that the user gave a world with dWorldSetStepThreadingImplementation. They step that world's islands
// instead of the process's own workers, and change no bits.
namespace dxWorldWorkers {

// Returns whether the user gave the world an implementation.
bool given(const dxWorld *world);

// Returns whether functions of the user's own, or the user's limit for the world, have a single thread run all calls of a step. They are then asked
// for all that upstream asks of them, in upstream's order: they may count calls, refuse them, or throw. (Calls of upstream's own
// functions are not observable, and a pool that no thread serves yet would block the step.)
bool haveToBeAsked(const dxWorld *world);

// Returns the number of workers that it lends.
unsigned count(const dxWorld *world);

// Called before a step. Returns false if the implementation refuses its resources: there is no step then, as in upstream.
bool prepare(const dxWorld *world);

void run(const dxWorld *world, unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context);

// The user has just given the world an implementation.
void lend(const dxWorld *world);

// Gives the workers of the world's implementation back, before it is exchanged or freed. Later runs of other worlds that use it make a new manager.
void giveBack(const dxWorld *world);

}  // namespace dxWorldWorkers
