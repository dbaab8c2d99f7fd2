// The part of a step that should go to remote workers, predicted from the cost of its islands in this process and the measurements of the links.
//
//   local     (1 - f) H + f P   on w threads    f  remote part, H  time of all islands on one thread of this process
//   remote    L + f (S / v + bytes t)           P  local part of a remote island: reading rows, packing, applying results
//                                               S  time of the solver, L  latency, v  speed of all workers, t  time per byte
//
// f makes both equal. It is 0 unless remote workers save a tenth of the local time, and some microseconds.
//
// Results never depend on it, only speed does.
//
// Threading: any thread.
#pragma once

#include "dynamics/step/dxRemoteSolvers.h"
#include "remote/coordinator/dxRemoteLink.h"

// Returns the part of a step's cost that should go to remote workers; 0: it does not pay.
double dxPredictRemoteShare(const dxRemoteWork &work, unsigned localThreads, const dxRemoteCapacity &capacity);

// The solver's part of the cost of an island.
constexpr double kRemoteSolverPart = 0.85;

// More islands are prepared than remote workers are predicted to solve: this process solves the rest.
constexpr double kRemoteReserve = 1.25;
