// The free motion of the bodies of a group: masses in the world's frame, and the velocities that the bodies would have at the end of the step
// without joints.
//
// The bodies and their accumulators do not change, so that a group may still be stepped in another way.
#pragma once

#include <cstddef>

#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxIslandStep.h"

// Writes the entries of bodies [begin, end) in `masses` and `velocities`; several threads may take a part each.
void dxFindFreeMotion(const dxIslandStep &step, std::size_t begin, std::size_t end, dxIslandBody *masses, dxSpatialMotion *velocities);

// Writes the entries of all bodies. Parallel.
void dxFindFreeMotion(const dxIslandStep &step, dxIslandBody *masses, dxSpatialMotion *velocities);
