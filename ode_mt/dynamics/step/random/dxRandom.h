// The random sequence of ODE: a linear congruential generator modulo 2^32.
//
// QuickStep shuffles its rows with it, so the sequence is part of the result. An island of m rows draws
// (m - 1) * floor((iterations - 1) / 8) numbers; the position of every island in the sequence follows
// by jumping ahead, and islands need not wait for one another.
//
// Source: dRand and dRandInt of ODE 0.16.2 (misc.cpp); jump-ahead by repeated squaring of the map
// x -> a x + c (Brown, "Random number generation with arbitrary strides", 1994).
#pragma once

#include <cstdint>

namespace dxRandom {

constexpr std::uint32_t kMultiplier = 1664525u;
constexpr std::uint32_t kIncrement = 1013904223u;

constexpr std::uint32_t next(std::uint32_t seed) { return kMultiplier * seed + kIncrement; }

// The seed after `draws` calls of next.
constexpr std::uint32_t jump(std::uint32_t seed, std::uint64_t draws) {
    std::uint32_t a = kMultiplier;
    std::uint32_t c = kIncrement;
    for (; draws != 0; draws >>= 1) {
        if (draws & 1) seed = a * seed + c;
        c *= a + 1;
        a *= a;
    }
    return seed;
}

// A number in [0, range) from the 32 bits drawn: they are folded to the fewest bits that hold `range`
// (1, 2, 4, 8, 16 or 32), which are then scaled.
constexpr int toRange(std::uint32_t drawn, std::uint32_t range) {
    unsigned bits = 32;
    while (bits > 1 && range <= (std::uint32_t{1} << (bits / 2))) {
        bits /= 2;
        drawn ^= drawn >> bits;
    }
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    return static_cast<int>(((drawn & mask) * range) >> bits);
}

// --- the sequence that all of the process shares (dRand, dRandSetSeed) ---------------------------

std::uint32_t sharedSeed();
void setSharedSeed(std::uint32_t seed);
std::uint32_t drawShared();

// Takes `draws` numbers at once, so that steps of different threads cannot interleave (contract C7).
// Returns the seed before the first of them.
std::uint32_t takeSharedBlock(std::uint64_t draws);

// Puts the shared sequence back from `expected` to `seed`, unless another thread has drawn since.
bool rewindShared(std::uint32_t expected, std::uint32_t seed);

}  // namespace dxRandom
