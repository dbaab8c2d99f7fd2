// One call of dSpaceCollide: who does what.
//
//   alone       everything on the calling thread
//   shared      boxes, search for pairs and contacts on workers; callbacks one at a time on the calling thread
//   concurrent  callbacks on workers too, with the program's consent (dxConcurrentCallbacks)
//
// Pairs, their order, contacts and callbacks are the same in all three. Under `auto` measured times decide
// (threading/payoff/dxSharingPolicy.h), under the other algorithms everything is shared that can be.
#pragma once

#include <ode/ode.h>

class dxOrderedSpace;

// Number of threads that a call may use, the calling one included; at least 1.
unsigned dxMaxCollisionThreads(const dxOrderedSpace &space);

void dxCollideSpace(dxOrderedSpace &space, void *data, dNearCallback *callback);
