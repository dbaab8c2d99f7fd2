// Which solver each world has: its own choice, or the process's (dxSettings).
//
// A list beside the worlds, of those with a choice of their own, since a world is upstream's structure. A step looks at one flag as
// long as no world is fast. Threading: any thread may call; a choice that is made while its world is stepped is the next step's at
// the earliest, and must not be made by the world's own memory manager.
#pragma once

#include <string>

#include <ode/ode.h>

#include "settings/dxSettings.h"

namespace dxWorldSolver {

dxSolverChoice of(const dxWorld *world);

inline bool isFast(const dxWorld *world) { return dxSettings::instance().mayBeFast() && of(world).solver == dxSolver::Fast; }

bool choose(const dxWorld *world, const std::string &name);  // false: unknown, reported with dMessage

void setTolerance(const dxWorld *world, double tolerance);  // from 0 to 1
void setWarmStart(const dxWorld *world, bool isWarm);

// The world is about to be destroyed.
void forget(const dxWorld *world);

}  // namespace dxWorldSolver
