// Random boxes with sizes over six decades, some of them NaN, infinite or inverted.
#pragma once

#include <cstdint>
#include <random>

#include "bounds.h"

class RandomBoxes {
public:
    explicit RandomBoxes(unsigned seed) : m_random(seed) {}

    dReal uniform(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(m_random); }
    std::uint32_t below(std::size_t end) { return static_cast<std::uint32_t>(m_random() % end); }
    bool oneIn(unsigned n) { return m_random() % n == 0; }

    dxBounds box();        // of any kind
    dxBounds properBox();  // finite

private:
    std::mt19937 m_random;
};
