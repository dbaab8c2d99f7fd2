// A case made small for as long as something is true of it.
#pragma once

#include "worlds/world_case.h"

#include <functional>

namespace fuzz_worlds {

// Leaves out files, elements, attributes, lines and bytes, and makes values simple. Ends after `seconds` at
// the latest.
WorldCase shrunk(WorldCase world, const std::function<bool(const WorldCase &)> &isInteresting,
                 double seconds);

}  // namespace fuzz_worlds
