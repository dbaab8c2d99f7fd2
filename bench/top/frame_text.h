// Frames in words: a table with a row for each world, and what there is to say of one.
#pragma once

#include <string>
#include <vector>

#include "top/frame_rates.h"

namespace top {

// Lines without their ends, the title first.
std::vector<std::string> tableOf(const std::vector<FrameRates> &worlds);

// Which part of the last frame took how long, and why what ran on one thread did.
std::vector<std::string> detailsOf(const FrameRates &rates);

// Both for all worlds, with what has no row. `refused`: worlds without one.
std::string textOf(const std::vector<FrameRates> &worlds, unsigned long long refused);

// Where there is no world.
extern const char *const kNoWorld;

}  // namespace top
