// The bytes that a script is drawn from: the first choose the settings in which it is played, the others the calls (draw.h).
// The seeded driver makes them of a seed, libFuzzer of inputs that reached new code.
#pragma once

#include "protocol.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

struct Input {
    RequestHeader request{};
    std::vector<std::uint8_t> script;
};

// Decodes the bytes. Missing bytes count as 0.
Input inputOf(const std::uint8_t *bytes, std::size_t count);

// Returns the bytes of a seed; every seed gives others.
std::vector<std::uint8_t> bytesOf(std::uint64_t seed);

// Returns the settings as lines of a script, which begin with '#'.
std::string settingOf(const RequestHeader &request);

}  // namespace fuzz
