// Random numbers for scenes: SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom
// number generators", OOPSLA 2014).
//
// It is not dRand, whose seed is part of the state that the library's own steps use, and does not use the distributions
// of <random>, whose results depend on the implementation.
#pragma once

#include <ode/ode.h>

#include <cstdint>

namespace scenes {

class Generator {
public:
    explicit Generator(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    // Evenly spread over [low, high).
    dReal between(dReal low, dReal high) {
        const double unit = static_cast<double>(next() >> 11) * 0x1p-53;
        return low + (high - low) * static_cast<dReal>(unit);
    }

private:
    std::uint64_t m_state;
};

}  // namespace scenes
