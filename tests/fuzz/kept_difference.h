// Reports and saves a script on which the two libraries differ.
#pragma once

#include "input.h"
#include "script_comparison.h"

#include <string>

namespace fuzz {

// Makes the script that was compared last small while it differs. Writes it to `folder`/`name`.script, unless `folder` is
// empty, and returns what differs, as text.
std::string keepDifference(Comparison &comparison, const Input &input, const std::string &name, const std::string &folder);

}  // namespace fuzz
