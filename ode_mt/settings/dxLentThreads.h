// The managers of threads that the program lends (dxThreadManagerUser): one for each lender, whoever uses it. Several worlds may share an
// implementation, and the process may have it too; two managers would have two calls waiting in its pool.
//
// In a forked child the threads are gone: whoever was lent them works alone there, until the child lends some itself.
//
// A run looks its manager up in a list that is as short as there are lenders. Any thread may call.
#pragma once

#include <memory>

#include <ode/ode.h>

#include "threading/managers/dxThreadManagerUser.h"

namespace dxLentThreads {

// The program lends these threads now.
void lend(const dxThreadLender &lender);

// Throws std::bad_alloc.
std::shared_ptr<dxThreadManagerUser> managerOf(const dxThreadLender &lender);

// The threads are to leave the library: waits for them, unless a run of another thread goes on, which then waits at its end. Who still uses
// the lender borrows them anew.
void giveBack(const dxThreadLender &lender);

}  // namespace dxLentThreads

// Workers of the threading implementation that the user gave a world with dWorldSetStepThreadingImplementation. They step that world's islands
// instead of the process's own workers, and change no bits.
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
