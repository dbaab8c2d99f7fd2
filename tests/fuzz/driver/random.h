// Numbers that follow from a seed alone, on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fuzz_driver {

// SplitMix64 (Steele, Lea, Flood 2014): every seed gives another sequence.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(mixed(seed)) {}

    std::uint64_t next() { return mixed(m_state += 0x9e3779b97f4a7c15u); }
    // Requires limit > 0.
    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(next() % limit); }
    bool oneIn(std::size_t times) { return below(times) == 0; }

    // Requires that `choices` is not empty.
    template <class Choice>
    const Choice &of(const std::vector<Choice> &choices) {
        return choices[below(choices.size())];
    }

private:
    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    // The state is not the seed itself: the sequences of consecutive seeds would overlap.
    std::uint64_t m_state;
};

}  // namespace fuzz_driver
