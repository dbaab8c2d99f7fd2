// Spaces of every kind, for scenarios that let each meet each.
#pragma once

#include "scenes/scene_options.h"

namespace exactness {

constexpr scenes::SpaceKind allSpaceKinds[] = {scenes::SpaceKind::Simple, scenes::SpaceKind::Hash,
                                               scenes::SpaceKind::SweepAndPrune, scenes::SpaceKind::QuadTree};

// As names of scenarios have it: "sweep_and_prune".
const char *nameOf(scenes::SpaceKind kind);

dSpaceID createSpace(scenes::SpaceKind kind, dSpaceID parent);

}  // namespace exactness
