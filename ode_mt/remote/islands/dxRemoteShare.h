// How much of a step should go out, predicted from what its islands cost at home and what the links measured.
//
//   home    (1 - f) H + f P   on w threads    f  part that goes out, H  time of all islands on one thread of home's
//   away    L + f (S / v + bytes t)           P  what is left at home of an island that goes out: reading rows, packing, applying results
//                                             S  time of the solver, L  latency, v  speed of all workers, t  time a byte
//
// f makes both equal. Nothing goes out unless that saves a tenth of the time that the step takes at home, and some microseconds.
//
// Results never depend on it, only speed does.
#pragma once

#include "dynamics/step/dxRemoteSolvers.h"
#include "remote/coordinator/dxRemoteLink.h"

// The part of a step's cost that should be sent; 0: it does not pay.
double dxPredictRemoteShare(const dxRemoteWork &work, unsigned homeThreads, const dxRemoteCapacity &capacity);

// Of an island that goes out, at home and at the worker.
constexpr double kRemoteSolverPart = 0.85;

// More islands are made ready than remote workers are predicted to solve: home takes what they do not.
constexpr double kRemoteReserve = 1.25;
