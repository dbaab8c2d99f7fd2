// Worlds drawn at random that use all of SDF's ways to say where something is: nested models, frames,
// relative poses, placement frames, included and merged models, joints in frames of their own, and what old
// versions wrote instead.
#pragma once

#include "test_folder.h"

#include <cstdint>
#include <string>

namespace small_world {

// Returns the text of a valid world of SDF 1.`version`, 4 to 9. Models that it includes are written to
// `folder`.
std::string randomSdf(std::uint32_t seed, int version, const TestFolder &folder);

}  // namespace small_world
