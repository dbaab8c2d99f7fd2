// How much of a step should go out, predicted from what its islands cost in this process and what the links measured.
//
//   here    (1 - f) H + f P   on w threads    f  part that goes out, H  time of all islands on one thread of this process
//   away    L + f (S / v + bytes t)           P  what is left here of an island that goes out: reading rows, packing, applying results
//                                             S  time of the solver, L  latency, v  speed of all workers, t  time a byte
//
// f makes both equal. Nothing goes out unless that saves a tenth of the time that the step takes here, and some microseconds.
//
// Results never depend on it, only speed does.
#pragma once

#include "dynamics/step/dxRemoteSolvers.h"
#include "remote/coordinator/dxRemoteLink.h"

// The part of a step's cost that should be sent; 0: it does not pay.
double dxPredictRemoteShare(const dxRemoteWork &work, unsigned localThreads, const dxRemoteCapacity &capacity);

// The solver's part of an island that goes out, here and at the worker.
constexpr double kRemoteSolverPart = 0.85;

// More islands are made ready than remote workers are predicted to solve: this process takes what they do not.
constexpr double kRemoteReserve = 1.25;
