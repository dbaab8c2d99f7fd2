// Whether the worlds of a plan have what it names, before its first run: bodies, joints, sensors, elements of SDF files.
#pragma once

#include "batch/plan.h"

namespace batch {

// Makes the world of the first run of each world of the plan. Throws std::runtime_error with what one of them has not. A world that ends
// its process, and what only other values of parameters bring about, is left to the run, which gets the status "error" for it.
//
// A process of its own makes them, which is left as it is by ODE's errors, random numbers and memory. Requires that no threads are running.
void checkWorlds(const Plan &plan);

}  // namespace batch
