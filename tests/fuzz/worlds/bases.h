// The worlds that are mutated: those of the repository with their models, one with something of everything,
// and one for each row of the loader's table of elements.
#pragma once

#include "worlds/world_case.h"

#include <vector>

namespace fuzz_worlds {

struct Bases {
    std::vector<WorldCase> small, large;
};

// `worldFolder` is the repository's.
Bases readBases(const std::filesystem::path &worldFolder);

}  // namespace fuzz_worlds
