// What the loader's errors and warnings keep to: one line that names a file of the case, an element of it and
// a reason, in the user's words.
#pragma once

#include "worlds/loading.h"

namespace fuzz_worlds {

// Empty, or what is wrong with them. `folder` holds the case's files.
std::string whatIsWrongWithMessages(const Loading &loading, const WorldCase &world,
                                    const std::filesystem::path &folder);

// The last element of a path that a message names: "link[a]".
std::string lastOf(const std::string &path);

}  // namespace fuzz_worlds
