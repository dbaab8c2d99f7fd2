// Recordings of odemt_record with other values, members and lines.
#pragma once

#include "driver/random.h"

#include <string>

namespace fuzz_options {

// Any text of JSON values, one a line, changed in a few places.
std::string mutatedLines(const std::string &text, fuzz_driver::Random &random);

}  // namespace fuzz_options
