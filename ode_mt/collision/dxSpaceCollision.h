// One call of dSpaceCollide: which of its parts run on workers.
//
//   alone       everything runs on the calling thread
//   shared      boxes, broad phase and contacts run on workers; callbacks run one at a time on the calling thread
//   concurrent  callbacks run on workers too, with the program's consent (dxConcurrentCallbacks)
//
// Pairs, their order, contacts and callbacks are the same in all three. Under `auto` measured times decide
// (threading/payoff/dxSharingPolicy.h); under the other algorithms everything that can be shared is.
#pragma once

#include <ode/ode.h>

class dxOrderedSpace;

// Returns the number of threads that a call may use, the calling one included; at least 1.
unsigned dxMaxCollisionThreads(const dxOrderedSpace &space);

void dxCollideSpace(dxOrderedSpace &space, void *data, dNearCallback *callback);
