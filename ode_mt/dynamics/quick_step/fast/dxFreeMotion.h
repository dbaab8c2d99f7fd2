// The bodies of a group before their constraints are solved: masses in the world's frame, and the velocities that they would have at the
// end of the step if no joint held them.
//
// Leaves the bodies' accumulators alone, so that a group may yet be stepped in another way.
#pragma once

#include <cstddef>

#include "dynamics/quick_step/fast/dxVelocities.h"
#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxIslandStep.h"

// Of bodies [begin, end). Writes their entries in `masses` and `velocities`; several threads may have a part each.
void dxFindFreeMotion(const dxIslandStep &step, std::size_t begin, std::size_t end, dxIslandBody *masses, dxVelocity *velocities);

// Of all bodies. Parallel.
void dxFindFreeMotion(const dxIslandStep &step, dxIslandBody *masses, dxVelocity *velocities);
