// What an array of 32-bit indices holds where there is nothing to point to.
#pragma once

#include <cstdint>

constexpr std::uint32_t kNoIndex = UINT32_MAX;
