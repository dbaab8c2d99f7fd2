// Numbers that look random and are the same with every library and compiler.
#pragma once

#include "scenes/vector3.h"

#include <cstdint>

namespace exactness {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : m_state(seed * 2 + 1) {}

    int below(int end) { return static_cast<int>(next() % static_cast<std::uint64_t>(end)); }
    bool oneIn(int count) { return below(count) == 0; }

    dReal between(dReal low, dReal high) {
        constexpr int bits = 30;
        return low + (high - low) * static_cast<dReal>(next() >> (31 - bits)) / (1 << bits);
    }

    scenes::Vector3 within(dReal halfEdge) {
        const dReal x = between(-halfEdge, halfEdge), y = between(-halfEdge, halfEdge);
        return {x, y, between(-halfEdge, halfEdge)};
    }

private:
    // A linear congruential generator; its upper bits are the better ones.
    std::uint64_t next() {
        m_state = m_state * 6364136223846793005u + 1442695040888963407u;
        return m_state >> 33;
    }

    std::uint64_t m_state;
};

}  // namespace exactness
