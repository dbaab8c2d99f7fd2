// Two members of a space, known by their slots.
#pragma once

#include <cstdint>

struct dxSlotPair {
    std::uint32_t a, b;
};
