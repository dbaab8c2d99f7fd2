// Which bodies a step handles together: those that are awake and connected by enabled joints, contacts among them.
#pragma once

#include <ode/ode.h>

#include <vector>

namespace record {

constexpr int kNoIsland = -1;  // of a body that sleeps

// The island of each body: islands are numbered from 0 in the order of their first bodies. Requires that contact joints are there
// still: between a scene's step() and finish().
std::vector<int> islandsOf(const std::vector<dBodyID> &bodies);

}  // namespace record
