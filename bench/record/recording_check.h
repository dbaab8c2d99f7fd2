// Whether a recording can be shown: with its world, and with others.
#pragma once

#include "record/recording.h"

namespace record {

// Whether two recordings are of one world: frames of two worlds differ whatever the engines do.
//
// Returns in a sentence why they are of different worlds; empty: nothing says so. Bodies are seen by their names and shapes.
std::string whyOtherWorld(const Header &one, const Header &other);

// Whether what was read can be drawn: kinds, counts, places in lists, ranges of numbers.
//
// Each throws std::runtime_error, naming what is wrong.
void checkHeader(const Header &header);
void checkFrame(const Frame &frame, const Header &header);

}  // namespace record
