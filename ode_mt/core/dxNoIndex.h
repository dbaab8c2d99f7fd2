// The value of a 32-bit index that points to nothing.
#pragma once

#include <cstdint>

constexpr std::uint32_t kNoIndex = UINT32_MAX;
