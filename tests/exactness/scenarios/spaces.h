// Spaces of every kind, for scenarios that collide every two.
#pragma once

#include "scenes/scene_options.h"

namespace exactness {

constexpr scenes::SpaceKind allSpaceKinds[] = {scenes::SpaceKind::Simple, scenes::SpaceKind::Hash,
                                               scenes::SpaceKind::SweepAndPrune, scenes::SpaceKind::QuadTree};

// Returns the name as in names of scenarios: "sweep_and_prune".
const char *nameOf(scenes::SpaceKind kind);

dSpaceID createSpace(scenes::SpaceKind kind, dSpaceID parent);

}  // namespace exactness
