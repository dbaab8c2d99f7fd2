// Texts for values: ordinary ones, and those that programs stumble over.
#pragma once

#include "random.h"

#include <string>

namespace fuzz_driver {

// One number: ordinary, whole, tiny, huge, zero, denormal, NaN, infinite, or spelled oddly.
std::string drawNumber(Random &random);

// What is no number: empty, blank, words, control characters, no UTF-8, format specifiers, very long.
std::string drawGarbage(Random &random);

// Either of these, or several numbers.
std::string drawText(Random &random);

}  // namespace fuzz_driver
