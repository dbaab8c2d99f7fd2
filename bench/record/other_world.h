// Whether two recordings are of one world: frames of two worlds differ whatever the engines do.
#pragma once

#include "record/recording.h"

namespace record {

// Returns in a sentence why they are of different worlds; empty: nothing says so. Bodies are seen by their names and shapes.
std::string whyOtherWorld(const Header &one, const Header &other);

}  // namespace record
