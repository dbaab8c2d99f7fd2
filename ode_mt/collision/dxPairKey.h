// The place of a pair of geoms in the order in which upstream's space would call back.
//
// Upstream walks its list of geoms; both orders follow from where the two geoms stand in the list. A
// member's rank tells that without the list: of two members, the one with the higher rank stands further to
// the front. Keys compare by their words in turn. docs/collision-order.md derives both orders.
#pragma once

#include <array>
#include <cstdint>

using dxRank = std::uint64_t;

struct dxPairKey {
    std::array<std::uint64_t, 4> words;

    // Of two with the same first word.
    bool followsBefore(const dxPairKey &b) const {
        for (std::size_t word = 1; word + 1 < words.size(); ++word)
            if (words[word] != b.words[word]) return words[word] < b.words[word];
        return words.back() < b.words.back();
    }

    friend bool operator<(const dxPairKey &a, const dxPairKey &b) { return a.words < b.words; }
};

// Front of the list first.
inline std::uint64_t dxFrontFirst(dxRank rank) { return ~rank; }
// Back of the list first.
inline std::uint64_t dxBackFirst(dxRank rank) { return rank; }
