// Numbers that look random, computed from any others: for hash tables and random sequences.
#pragma once

#include <cstdint>

// The finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", 2014): each bit of the result
// depends on all of `bits`.
inline std::uint64_t dxMixedBits(std::uint64_t bits) {
    bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
    return bits ^ bits >> 31;
}

// The state of that generator after a draw is the one before it plus this.
constexpr std::uint64_t kMixedBitsStep = 0x9e3779b97f4a7c15u;
