// The place of a pair of geoms in the order in which upstream's space would call back.
//
// Upstream walks its list of geoms; both orders follow from where the two geoms stand in the list. A
// member's rank tells that without the list: of two members, the one with the higher rank stands further to
// the front. Keys compare by their words in turn. docs/collision.md derives both orders.
#pragma once

#include <array>
#include <cstdint>

using dxRank = std::uint64_t;

struct dxPairKey {
    std::array<std::uint64_t, 4> words;

    friend bool operator<(const dxPairKey &a, const dxPairKey &b) { return a.words < b.words; }
};

// Front of the list first.
inline std::uint64_t dxFrontFirst(dxRank rank) { return ~rank; }
// Back of the list first.
inline std::uint64_t dxBackFirst(dxRank rank) { return rank; }
