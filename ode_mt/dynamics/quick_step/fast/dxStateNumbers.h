// Random numbers that follow from the state: a step from the same state draws the same numbers, another step draws others, and no other
// sequence changes. Orders are drawn with them (docs/fast.md).
#pragma once

#include <cstdint>
#include <cstring>

#include <ode/common.h>

#include "core/dxMixedBits.h"

namespace dxStateNumbers {

inline std::uint64_t bitsOf(double number) {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

// Returns the mixed bits of a position.
inline std::uint64_t bitsOf(const dVector3 place) {
    std::uint64_t bits = 0;
    for (int axis = 0; axis < 3; ++axis) bits = dxMixedBits(bits ^ bitsOf(static_cast<double>(place[axis])));
    return bits;
}

// Returns a number in [0, count) from mixed bits.
inline unsigned below(std::uint64_t bits, unsigned count) { return static_cast<unsigned>((bits >> 32) * count >> 32); }

}  // namespace dxStateNumbers
