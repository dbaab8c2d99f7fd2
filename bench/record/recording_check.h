// Whether what was read can be drawn: kinds, counts, places in lists, ranges of numbers.
#pragma once

#include "record/recording.h"

namespace record {

// Each throws std::runtime_error, naming what is wrong.
void checkHeader(const Header &header);
void checkFrame(const Frame &frame, const Header &header);

}  // namespace record
