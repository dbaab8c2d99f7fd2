// A case with some of its files changed: trees, numbers in them, or bytes.
#pragma once

#include "driver/random.h"
#include "worlds/world_case.h"

namespace fuzz_worlds {

void mutateCase(WorldCase &world, fuzz_driver::Random &random);

}  // namespace fuzz_worlds
